"""A small output folder of a replay, for the tests of the converters: five frames a second apart, the second lost."""
import json
import pathlib
import struct

START = 1_403_636_579_763_555_584  # ns; more digits than a float keeps
CAMERA = {"width": 64, "height": 48, "fx": 50.0, "fy": 50.0, "cx": 31.5, "cy": 23.5, "distortion": "radial_tangential",
          "coefficients": [0.1, 0.0, 0.0, 0.0]}
HEADER = "index,t_ns,state,tracker,switch_reason,update_ms,mapping_ms,visible,inliers,rms,keyframe,map_revision\n"
STATES = ["tracking,indirect", "lost,none", "tracking,indirect", "tracking,direct", "tracking,direct"]
PLY = ("ply\nformat binary_little_endian 1.0\ncomment c\nelement vertex 2\n"
       "property float x\nproperty float y\nproperty float z\n"
       "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int observations\nend_header\n")


def time(index):
    return START + index * 10**9


def seconds(t_ns):
    return f"{t_ns // 10**9}.{t_ns % 10**9:09d}"


def tum(lines):
    return "# timestamp tx ty tz qx qy qz qw\n" + "".join(
        f"{seconds(t_ns)} {x} {y} {z} 0.0 0.0 0.0 1.0\n" for t_ns, (x, y, z) in lines)


def position(index):
    """Of the camera at a frame."""
    return (0.1 * index, 0.01 * index * index, 0.0)


def truth(index):
    """The same in metres: turned by a right angle about z, twice as large, and elsewhere."""
    x, y, z = position(index)
    return (1.0 - 2.0 * y, 2.0 + 2.0 * x, 3.0 + 2.0 * z)


def write(folder):
    """Writes the files; returns the folder."""
    folder = pathlib.Path(folder)
    tracked = [0, 2, 3, 4]
    source = {"path": "/data/walk", "frames": len(STATES)}
    (folder / "stats.json").write_text(json.dumps({"source": source, "config": {"camera": CAMERA}}))
    (folder / "frames.csv").write_text(HEADER + "".join(
        f"{i},{time(i)},{state},none,{1.5 * i},0.0,100,{90 + i},2.5,0,7\n" for i, state in enumerate(STATES)))
    (folder / "trajectory.tum").write_text(tum((time(i), position(i)) for i in tracked))
    (folder / "keyframes.tum").write_text(tum((time(i), position(i)) for i in (0, 2)))
    (folder / "groundtruth.tum").write_text(tum((time(i), truth(i)) for i in range(5)))
    vertices = struct.pack("<3f3Bi", 1, 2, 3, 10, 20, 30, 4) + struct.pack("<3f3Bi", -1, 0, 5, 255, 0, 128, 300)
    (folder / "map.ply").write_bytes(PLY.encode() + vertices)
    return folder


def write_images(folder):
    """An image for each frame, named by its time."""
    folder = pathlib.Path(folder)
    for i in range(len(STATES)):
        (folder / f"{time(i)}.png").write_bytes(b"picture %d" % i)
    return folder
