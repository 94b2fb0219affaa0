#!/usr/bin/env python3
"""Writes a changed copy of a sequence: portrait, cropped (EuRoC only, needs ffmpeg) or partly black.

usage: make_variant.py SOURCE OUT (--rotate | --crop WxH | --blackout A:B)
  --rotate        turn the camera by 90 degrees: pixel (u, v) moves to (height - 1 - v, u)
  --crop WxH      keep the upper left W x H pixels
  --blackout A:B  images A to B - 1 are black (EuRoC or TUM, PNG images)
The ground truth is the body's and stays as it is; when the image changes its shape, T_BS and the intrinsics do, too.
"""
import argparse
import os
import re
import shutil
import struct
import subprocess
import sys
import zlib


def numbers(text, key):
    match = re.search(key + r":\s*\[([^\]]*)\]", text)
    if not match:
        sys.exit(f"sensor.yaml has no list '{key}'")
    return [float(x) for x in match.group(1).replace("\n", " ").split(",")]


def rotate(camera):
    fx, fy, cx, cy = camera["intrinsics"]
    k1, k2, p1, p2 = camera["distortion_coefficients"]
    width, height = camera["resolution"]
    t = camera["T_BS"]
    # p_old = R p_new with R = [[0, 1, 0], [-1, 0, 0], [0, 0, 1]], because x_new = -y_old and y_new = x_old.
    turned = []
    for row in range(4):
        a, b, c, d = t[4 * row:4 * row + 4]
        turned += [-b, a, c, d]
    return {
        "intrinsics": [fy, fx, height - 1 - cy, cx],
        "distortion_coefficients": [k1, k2, p2, -p1],
        "resolution": [height, width],
        "T_BS": turned,
    }


def crop(camera, size):
    return dict(camera, resolution=size)


def write_sensor(path, camera):
    def listed(values):
        return "[" + ", ".join(repr(v) for v in values) + "]"

    with open(path, "w", encoding="utf-8") as out:
        out.write("sensor_type: camera\n")
        out.write("T_BS:\n  cols: 4\n  rows: 4\n  data: " + listed(camera["T_BS"]) + "\n")
        out.write("resolution: " + listed([int(v) for v in camera["resolution"]]) + "\n")
        out.write("camera_model: pinhole\nintrinsics: " + listed(camera["intrinsics"]) + "\n")
        out.write("distortion_model: radial-tangential\ndistortion_coefficients: ")
        out.write(listed(camera["distortion_coefficients"]) + "\n")


def convert(source, target, image_filter):
    """All images in one run of ffmpeg, which numbers them; they get their names back afterwards."""
    os.makedirs(target, exist_ok=True)
    names = sorted(name for name in os.listdir(source) if name.endswith(".png"))
    numbered = os.path.join(target, "%06d.tmp.png")
    pattern = ["-pattern_type", "glob", "-i", os.path.join(source, "*.png")]
    subprocess.run(["ffmpeg", "-v", "error", "-y", *pattern, "-vf", image_filter, "-start_number", "0", numbered], check=True)
    for index, name in enumerate(names):
        os.replace(numbered % index, os.path.join(target, name))


def black_png(like):
    """The bytes of a black gray image as large as the one in the file `like`."""
    with open(like, "rb") as image:
        header = image.read(24)
    if header[12:16] != b"IHDR":
        sys.exit(f"{like} is no PNG")
    width, height = struct.unpack(">II", header[16:24])
    rows = zlib.compress(bytes((1 + width) * height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    shape = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", shape) + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


def black_out(source, target, first, end):
    shutil.copytree(source, target, dirs_exist_ok=True)
    folders = [os.path.join(target, *parts) for parts in (("mav0", "cam0", "data"), ("rgb",))]
    images = next((folder for folder in folders if os.path.isdir(folder)), None)
    if images is None:
        sys.exit(f"{source} has neither mav0/cam0/data nor rgb")
    names = sorted(name for name in os.listdir(images) if name.endswith(".png"))
    for name in names[first:end]:
        path = os.path.join(images, name)
        black = black_png(path)
        with open(path, "wb") as image:
            image.write(black)


def change_shape(options):
    source = os.path.join(options.source, "mav0")
    target = os.path.join(options.out, "mav0")
    with open(os.path.join(source, "cam0", "sensor.yaml"), encoding="utf-8") as text:
        yaml = text.read()
    camera = {key: numbers(yaml, key) for key in ("intrinsics", "distortion_coefficients", "resolution")}
    camera["T_BS"] = numbers(yaml, "data")
    if options.rotate:
        camera, image_filter = rotate(camera), "transpose=clock"
    else:
        size = [int(v) for v in options.crop.split("x")]
        camera, image_filter = crop(camera, size), f"crop={size[0]}:{size[1]}:0:0:exact=1"
    convert(os.path.join(source, "cam0", "data"), os.path.join(target, "cam0", "data"), image_filter)
    shutil.copy(os.path.join(source, "cam0", "data.csv"), os.path.join(target, "cam0", "data.csv"))
    truth = "state_groundtruth_estimate0"
    shutil.copytree(os.path.join(source, truth), os.path.join(target, truth), dirs_exist_ok=True)
    write_sensor(os.path.join(target, "cam0", "sensor.yaml"), camera)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source")
    parser.add_argument("out")
    how = parser.add_mutually_exclusive_group(required=True)
    how.add_argument("--rotate", action="store_true")
    how.add_argument("--crop")
    how.add_argument("--blackout", type=lambda text: [int(v) for v in text.split(":")], metavar="A:B")
    options = parser.parse_args()
    if options.blackout:
        black_out(options.source, options.out, *options.blackout)
    else:
        change_shape(options)


if __name__ == "__main__":
    main()
