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


def numbered(files, run):
    """{time: file}: the first file is the frame of index 0. ValueError when the replay did not take every file, each
    a frame: then nothing says which file a frame is. The times of such files are multiples of their period."""
    if len(files) != run.source_frames:
        raise ValueError(f"--images: {len(files)} PNG, JPEG or WebP images, but the replay took {run.source_frames}: "
                         "names that are no times can be told apart only when it took them all")
    last = run.frames[-1] if run.frames else None
    period = last.t_ns / last.index if last and last.index else 0
    if any(abs(frame.t_ns - frame.index * period) > 0.1 * period for frame in run.frames):
        raise ValueError("--images: the replay left images out, and names that are no times do not tell which")
    return {frame.t_ns: files[frame.index] for frame in run.frames if frame.index < len(files)}


def find(folder, run):
    """{t_ns: file} for the frames whose image is there. By the list of the dataset, by names that are
    times, else in natural order."""
    folder = pathlib.Path(folder)
    files = sorted((f for f in folder.iterdir() if f.suffix.lower() in EXTENSIONS), key=natural)
    by_time = listed(folder) or named_by_time(files) or numbered(files, run)
    found = {frame.t_ns: by_time.get(frame.t_ns) for frame in run.frames}
    return {t: file for t, file in found.items() if file and file.suffix.lower() in EXTENSIONS and file.exists()}
