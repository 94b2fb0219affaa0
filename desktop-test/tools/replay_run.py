"""The output folder of a replay (docs/replay.md), read for the converters."""
import csv
import dataclasses
import json
import pathlib
import re
import struct

import similarity


@dataclasses.dataclass(frozen=True)
class Pose:
    """A camera in the world: x right, y down, z forward; the quaternion is x y z w."""

    t_ns: int
    position: tuple
    q_xyzw: tuple


@dataclasses.dataclass(frozen=True)
class Vertex:
    position: tuple
    rgb: tuple
    observations: int


@dataclasses.dataclass(frozen=True)
class Frame:
    """A line of frames.csv."""

    index: int
    t_ns: int
    state: str
    tracker: str
    numbers: dict  # of the columns that are numbers: update_ms, visible, inliers, rms, ...


@dataclasses.dataclass
class Run:
    camera: dict  # stats.json: config.camera
    name: str
    source_frames: int  # images that were to be replayed
    frames: list
    trajectory: list
    keyframes: list
    landmarks: list
    truth: list  # moved, turned and scaled onto the trajectory; empty without ground truth

    def trackers(self):
        """Who placed the frame at a time."""
        return {frame.t_ns: frame.tracker for frame in self.frames}


WORDS = {"index", "t_ns", "state", "tracker", "switch_reason"}


def nanoseconds(seconds):
    """Decimal seconds as text, without a detour through float."""
    whole, _, decimals = seconds.partition(".")
    sign = -1 if whole.startswith("-") else 1
    return int(whole) * 10**9 + sign * int(decimals[:9].ljust(9, "0") or "0")


def read_tum(path):
    poses = []
    for line in path.read_text().splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        time, *values = line.split()
        numbers = tuple(map(float, values))
        poses.append(Pose(nanoseconds(time), numbers[:3], numbers[3:7]))
    return poses


def read_frames(path):
    with path.open(newline="") as file:
        return [
            Frame(int(row["index"]), int(row["t_ns"]), row["state"], row["tracker"],
                  {key: float(value) for key, value in row.items() if key not in WORDS})
            for row in csv.DictReader(file)
        ]


def read_ply(path):
    """The vertices of map.ply; ValueError when it is another kind of PLY."""
    data = path.read_bytes()
    marker = b"end_header\n"
    header, body = data[: data.index(marker)].decode(), data.index(marker) + len(marker)
    properties = re.findall(r"property (\w+) (\w+)", header)
    expected = [("float", axis) for axis in "xyz"]
    expected += [("uchar", color) for color in ("red", "green", "blue")] + [("int", "observations")]
    if "binary_little_endian" not in header or properties != expected:
        raise ValueError(f"{path} is not a map.ply of glide replay")
    count = int(re.search(r"element vertex (\d+)", header).group(1))
    layout = struct.Struct("<3f3Bi")
    values = (layout.unpack_from(data, body + i * layout.size) for i in range(count))
    return [Vertex(v[:3], v[3:6], v[6]) for v in values]


def aligned(truth, trajectory):
    """The truth in the world and the unit of the trajectory; empty when the two share too few times."""
    times = {pose.t_ns: pose.position for pose in truth}
    pairs = [(times[pose.t_ns], pose.position) for pose in trajectory if pose.t_ns in times]
    pairs = pairs or nearest_pairs(truth, trajectory)
    found = similarity.align([a for a, _ in pairs], [b for _, b in pairs])
    if found is None:
        return []
    return [Pose(pose.t_ns, found.point(pose.position), found.turn(pose.q_xyzw)) for pose in truth]


def nearest_pairs(truth, trajectory, tolerance_ns=10_000_000):
    """Positions of poses of both that are at most 10 ms apart, as for the ATE."""
    pairs, i = [], 0
    for pose in trajectory:
        while i + 1 < len(truth) and abs(truth[i + 1].t_ns - pose.t_ns) <= abs(truth[i].t_ns - pose.t_ns):
            i += 1
        if truth and abs(truth[i].t_ns - pose.t_ns) <= tolerance_ns:
            pairs.append((truth[i].position, pose.position))
    return pairs


def read_run(folder):
    """Everything; OSError, ValueError or KeyError when the folder is no whole output of a replay."""
    folder = pathlib.Path(folder)
    stats = json.loads((folder / "stats.json").read_text())
    trajectory = read_tum(folder / "trajectory.tum")
    truth_file = folder / "groundtruth.tum"
    truth = read_tum(truth_file) if truth_file.exists() else []
    return Run(
        camera=stats["config"]["camera"],
        name=pathlib.Path(stats["source"]["path"]).name,
        source_frames=stats["source"]["frames"],
        frames=read_frames(folder / "frames.csv"),
        trajectory=trajectory,
        keyframes=read_tum(folder / "keyframes.tum"),
        landmarks=read_ply(folder / "map.ply"),
        truth=aligned(truth, trajectory),
    )
