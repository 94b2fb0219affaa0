#!/usr/bin/env python3
"""Turns the output folder of a replay into one MCAP file that Foxglove and Lichtblick open (docs/exports.md)."""
import json

import colors
import converter
import foxglove
import replay_run

try:
    from mcap.writer import Writer
except ImportError:
    Writer = None

ROOT, WORLD, CAMERA = "map", "world", "camera"  # frames: z up, the map's axes, the lens
STATISTICS = "glide.FrameStats"


def schema_of(name):
    return foxglove.SCHEMAS.get(name, {"title": name, "type": "object"})


class Log:
    """Messages on topics; a topic and its schema are announced with its first message."""

    def __init__(self, stream):
        self.writer = Writer(stream)
        self.writer.start(profile="", library="GLidE-SLAM to_mcap.py")
        self.schemas, self.channels = {}, {}

    def add(self, t_ns, topic, name, message):
        if name not in self.schemas:
            self.schemas[name] = self.writer.register_schema(name, "jsonschema", json.dumps(schema_of(name)).encode())
        if topic not in self.channels:
            self.channels[topic] = self.writer.register_channel(topic, "json", self.schemas[name])
        self.writer.add_message(self.channels[topic], t_ns, json.dumps(message).encode(), t_ns)


# Each message below is (time, topic, schema, function that makes it).


def of_map(run, t_ns):
    """What stays as it is: at the first time of the file."""
    upright = replay_run.Pose(t_ns, (0.0, 0.0, 0.0), foxglove.UPRIGHT_FROM_WORLD)
    strips = [foxglove.strip([p.position for p in poses], [colors.share(color) for color in of_points])
              for poses, of_points in colors.strips(run)]
    if run.truth:
        strips.append(foxglove.strip([p.position for p in run.truth], [colors.share(colors.TRUTH)]))
    # A topic of its own: viewers that jump to a time look for the last message of each.
    yield t_ns, "/tf_static", "foxglove.FrameTransform", lambda: foxglove.transform(t_ns, ROOT, WORLD, upright)
    yield t_ns, "/map/landmarks", "foxglove.PointCloud", lambda: foxglove.point_cloud(WORLD, t_ns, run.landmarks)
    yield t_ns, "/map/keyframes", "foxglove.PosesInFrame", lambda: foxglove.poses_in(WORLD, t_ns, run.keyframes)
    yield t_ns, "/map/trajectory", "foxglove.SceneUpdate", lambda: foxglove.scene(WORLD, t_ns, "trajectory", strips)


def of_camera(run):
    for pose in run.trajectory:
        yield (pose.t_ns, "/tf", "foxglove.FrameTransform",
               lambda pose=pose: foxglove.transform(pose.t_ns, WORLD, CAMERA, pose))
        yield pose.t_ns, "/camera/pose", "foxglove.PoseInFrame", lambda pose=pose: foxglove.pose_in(WORLD, pose)
    for pose in run.truth:
        yield pose.t_ns, "/groundtruth/pose", "foxglove.PoseInFrame", lambda pose=pose: foxglove.pose_in(WORLD, pose)


def of_frames(run, images):
    for frame in run.frames:
        t_ns = frame.t_ns
        values = {"index": frame.index, "state": frame.state, "tracker": frame.tracker, **frame.numbers}
        yield t_ns, "/stats", STATISTICS, lambda values=values: values
        yield (t_ns, "/camera/calibration", "foxglove.CameraCalibration",
               lambda t_ns=t_ns: foxglove.calibration(CAMERA, t_ns, run.camera))
        if t_ns in images:
            yield (t_ns, "/camera/image", "foxglove.CompressedImage",
                   lambda t_ns=t_ns: foxglove.image(CAMERA, t_ns, images[t_ns]))


def convert(run, images, path):
    """Writes the file, in the order of time; images is {t_ns: file}."""
    start = run.frames[0].t_ns if run.frames else 0
    messages = [*of_map(run, start), *of_camera(run), *of_frames(run, images)]
    with open(path, "wb") as stream:
        log = Log(stream)
        for t_ns, topic, schema, make in sorted(messages, key=lambda message: message[0]):
            log.add(t_ns, topic, schema, make())
        log.writer.finish()


def main():
    converter.main(__doc__, ("mcap", Writer), ".mcap", convert)


if __name__ == "__main__":
    main()
