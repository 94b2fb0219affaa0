"""The command line that the converters share."""
import argparse
import pathlib
import sys

import replay_images
import replay_run


def main(description, package, suffix, convert):
    """Reads a replay's output folder and runs convert(run, images, file); package is (name, the module or None)."""
    name = pathlib.Path(sys.argv[0]).name
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("folder", type=pathlib.Path, help="what ./glide replay wrote (-o)")
    parser.add_argument("file", type=pathlib.Path, nargs="?", help=f"default: FOLDER/run{suffix}")
    parser.add_argument("--images", type=pathlib.Path, help="the folder that was replayed: its images, too")
    options = parser.parse_args()
    if package[1] is None:
        sys.exit(f"{name} needs the package {package[0]} (desktop-test/tools/requirements.txt)")
    path = options.file or options.folder / f"run{suffix}"
    try:
        run = replay_run.read_run(options.folder)
        images = replay_images.find(options.images, run) if options.images else {}
        convert(run, images, path)
    except (OSError, ValueError, KeyError) as fault:
        sys.exit(f"{name}: {fault}")
    print(f"{path}: {len(run.trajectory)} poses, {len(run.landmarks)} landmarks, {len(images)} images")
