#!/usr/bin/env python3
"""Turns the output folder of a replay into one .rrd file for the Rerun viewer (docs/exports.md)."""
import colors
import converter
import similarity

try:
    import rerun
except ImportError:
    rerun = None

FRUSTUM_DEPTH = 0.045  # scene units: MapStyle::frustum_size
CURVES = ("update_ms", "mapping_ms", "visible", "inliers", "rms")


def frustum(camera, pose):
    """One line around a keyframe: through its eye and the corners of its image."""
    def corner(u, v):
        ray = ((u - camera["cx"]) / camera["fx"], (v - camera["cy"]) / camera["fy"], 1.0)
        turned = similarity.rotate(pose.q_xyzw, [FRUSTUM_DEPTH * value for value in ray])
        return tuple(a + b for a, b in zip(turned, pose.position))

    right, bottom = camera["width"] - 1, camera["height"] - 1
    a, b, c, d = corner(0, 0), corner(right, 0), corner(right, bottom), corner(0, bottom)
    return [pose.position, a, b, pose.position, c, d, pose.position, a, d, c, b]


def by_color(poses, of_points):
    """[(points, colour)] of a stretch, cut where the colour changes: Rerun gives a strip one colour."""
    pieces = []
    for i in range(1, len(poses)):
        if not pieces or pieces[-1][1] != of_points[i]:
            pieces.append(([poses[i - 1].position], of_points[i]))
        pieces[-1][0].append(poses[i].position)
    return pieces


def log_map(run):
    rerun.log("world", rerun.ViewCoordinates.RDF, static=True)
    rerun.log("world/landmarks",
              rerun.Points3D([v.position for v in run.landmarks], colors=[v.rgb for v in run.landmarks]), static=True)
    rerun.log("world/keyframes",
              rerun.LineStrips3D([frustum(run.camera, pose) for pose in run.keyframes], colors=[colors.INDIRECT]),
              static=True)
    pieces = [piece for stretch in colors.strips(run) for piece in by_color(*stretch)]
    rerun.log("world/trajectory",
              rerun.LineStrips3D([points for points, _ in pieces], colors=[color for _, color in pieces]), static=True)
    if run.truth:
        rerun.log("world/groundtruth",
                  rerun.LineStrips3D([[pose.position for pose in run.truth]], colors=[colors.TRUTH]), static=True)
    camera = run.camera
    rerun.log("world/camera",
              rerun.Pinhole(focal_length=[camera["fx"], camera["fy"]], principal_point=[camera["cx"], camera["cy"]],
                            width=camera["width"], height=camera["height"], camera_xyz=rerun.ViewCoordinates.RDF,
                            image_plane_distance=2 * FRUSTUM_DEPTH), static=True)


def log_frames(run, images):
    poses = {pose.t_ns: pose for pose in run.trajectory}
    for frame in run.frames:
        rerun.set_time("time", duration=(frame.t_ns - run.frames[0].t_ns) * 1e-9)
        rerun.set_time("frame", sequence=frame.index)
        if frame.t_ns in poses:
            pose = poses[frame.t_ns]
            rerun.log("world/camera", rerun.Transform3D(translation=pose.position,
                                                        quaternion=rerun.Quaternion(xyzw=pose.q_xyzw)))
        if frame.t_ns in images:
            rerun.log("world/camera", rerun.EncodedImage(path=images[frame.t_ns]))
        for curve in CURVES:
            rerun.log(f"stats/{curve}", rerun.Scalars(frame.numbers[curve]))
        rerun.log("stats/state", rerun.TextLog(f"{frame.state} {frame.tracker}"))


def convert(run, images, path):
    """Writes the file; images is {t_ns: file}."""
    rerun.init("glide-slam", recording_id=run.name)
    rerun.save(path)
    log_map(run)
    log_frames(run, images)


def main():
    converter.main(__doc__, ("rerun-sdk", rerun), ".rrd", convert)


if __name__ == "__main__":
    main()
