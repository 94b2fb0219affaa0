#!/usr/bin/env python3
"""Writes a portrait or cropped copy of a EuRoC sequence, images and calibration alike.

usage: make_variant.py SOURCE OUT (--rotate | --crop WxH)
  --rotate     turn the camera by 90 degrees: pixel (u, v) moves to (height - 1 - v, u)
  --crop WxH   keep the upper left W x H pixels
The ground truth is the body's and stays as it is; T_BS and the intrinsics change. Needs ffmpeg.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys


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


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source")
    parser.add_argument("out")
    parser.add_argument("--rotate", action="store_true")
    parser.add_argument("--crop")
    options = parser.parse_args()
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


if __name__ == "__main__":
    main()
