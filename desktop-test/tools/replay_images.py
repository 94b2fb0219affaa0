"""The images of a replay's source, found for its frames."""
import csv
import pathlib
import re

import replay_run

EXTENSIONS = {".png", ".jpg", ".jpeg", ".webp"}  # what the viewers decode


def natural(path):
    """Sorts img2 before img10."""
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", path.name)]


def listed(folder):
    """{time: file} of a TUM or EuRoC list in the folder, or None."""
    if (folder / "rgb.txt").exists():
        lines = (line.split() for line in (folder / "rgb.txt").read_text().splitlines())
        return {replay_run.nanoseconds(f[0]): folder / f[1] for f in lines if f and not f[0].startswith("#")}
    for name in ("mav0/cam0/data.csv", "cam0/data.csv", "data.csv"):
        path = folder / name
        if path.exists():
            rows = csv.reader(line for line in path.read_text().splitlines() if not line.startswith("#"))
            return {int(row[0]): path.parent / "data" / row[1].strip() for row in rows if row}
    return None


def named_by_time(files):
    """{time: file} when all names are nanoseconds or decimal seconds, else None."""
    if files and all(re.fullmatch(r"\d{16,}", file.stem) for file in files):
        return {int(file.stem): file for file in files}
    if files and all(re.fullmatch(r"\d+\.\d+", file.stem) for file in files):
        return {replay_run.nanoseconds(file.stem): file for file in files}
    return None


def find(folder, frames):
    """{t_ns: file} for the frames whose image is there. By the list of the dataset, by names that are
    times, else in natural order: the first file is the frame of index 0."""
    folder = pathlib.Path(folder)
    files = sorted((f for f in folder.iterdir() if f.suffix.lower() in EXTENSIONS), key=natural)
    by_time = listed(folder) or named_by_time(files)
    if by_time is None:
        by_time = {frame.t_ns: files[frame.index] for frame in frames if frame.index < len(files)}
    found = {frame.t_ns: by_time.get(frame.t_ns) for frame in frames}
    return {t: file for t, file in found.items() if file and file.suffix.lower() in EXTENSIONS and file.exists()}
