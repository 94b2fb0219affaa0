"""Rendering and replaying with a cache: what was rendered with the same arguments is kept."""
import csv
import json
import os
import shutil
import subprocess

import poses


class Failure(Exception):
    """A program that a suite needs did not do its part."""


class Run:
    """What glide-replay wrote."""

    def __init__(self, folder, source):
        self.folder = folder
        with open(os.path.join(folder, "stats.json"), encoding="utf-8") as text:
            self.stats = json.load(text)
        with open(os.path.join(folder, "frames.csv"), encoding="utf-8", newline="") as text:
            self.frames = list(csv.DictReader(text))
        self.live = poses.read_tum(os.path.join(folder, "trajectory_live.tum"))
        truth = os.path.join(source, "groundtruth.txt")
        self.truth = poses.read_tum(truth) if os.path.exists(truth) else {}

    def time(self, frame):
        """As in the trajectories, microseconds."""
        return round(int(self.frames[frame]["t_ns"]) / 1000)

    def is_tracked(self, frame):
        return self.frames[frame]["state"] == "tracking"

    def ate(self):
        return (self.stats["accuracy"] or {}).get("ate_rmse_m")

    def lost_frames(self):
        """Frames after the first pose that are not tracked."""
        first = self.stats["first_pose_index"]
        return None if first is None else sum(not self.is_tracked(i) for i in range(first, len(self.frames)))


class Tools:
    """The programs, and the folder that all of it goes to."""

    def __init__(self, options):
        self.synth_program, self.replay_program = options.synth, options.replay
        self.data, self.out = options.data, options.out
        self.reuse = options.reuse

    def render(self, name, *arguments):
        """The folder of a rendered sequence, rendered when it is not there with the same arguments."""
        folder = os.path.join(self.out, "sequences", name)
        marker = os.path.join(folder, "made_with.txt")
        wanted = " ".join(arguments)
        if os.path.exists(marker):
            with open(marker, encoding="utf-8") as text:
                if text.read() == wanted:
                    return folder
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(os.path.dirname(folder), exist_ok=True)
        done = subprocess.run([self.synth_program, folder, "--quiet", *arguments], check=False)
        if done.returncode != 0:
            raise Failure(f"glide-synth {name} {wanted} exits with {done.returncode}")
        with open(marker, "w", encoding="utf-8") as text:
            text.write(wanted)
        return folder

    def replay(self, name, source, *arguments):
        folder = os.path.join(self.out, "runs", name)
        if self.reuse and os.path.exists(os.path.join(folder, "stats.json")):
            return Run(folder, source)
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(os.path.dirname(folder), exist_ok=True)
        command = [self.replay_program, source, "--deterministic", "--backend", "cpu", "--progress", "none", "-o", folder,
                   *arguments]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0:
            raise Failure(f"{' '.join(command)} exits with {done.returncode}:\n{done.stdout}")
        return Run(folder, source)
