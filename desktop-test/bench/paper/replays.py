"""Replays a sequence several times and puts the runs together."""
import json
import os
import shutil
import statistics
import subprocess

TRACKERS = ("hybrid", "indirect")

# Name here, and where it stands in stats.json.
NUMBERS = {
    "frame_ms": ("time_ms", "update", "median"),
    "pre_ms": ("gpu", "pre_ms", "median"),
    "trk_ms": ("gpu", "trk_ms", "median"),
    "direct_share": ("direct_share",),
    "ate_m": ("accuracy", "ate_rmse_m"),
    "tracked_ratio": ("tracked_ratio",),
    "frames_in": ("frames", "in"),
    "frames_dropped": ("frames", "dropped"),
}
NEVER_INITIALISED, UNREADABLE, NO_GL = 4, 2, 3
REASONS = {NEVER_INITIALISED: "never initialised", UNREADABLE: "unreadable", NO_GL: "no GL"}


def number_at(stats, path):
    """The value at a path of keys; None where a part of it is null or missing."""
    for key in path:
        stats = (stats or {}).get(key)
    return stats


class Replayer:
    """Runs glide-replay into a folder."""

    def __init__(self, program, out, options):
        self.program, self.out, self.options = program, out, options

    def command(self, sequence, tracker, folder):
        return [self.program, f"{sequence.kind}:{sequence.path}", "--tracker", tracker, "--patch", str(sequence.patch),
                "--levels", str(self.options.levels), "--backend", self.options.backend, "--pace", "realtime",
                "--progress", "none", "--output", folder]

    def run(self, sequence, tracker, index):
        """What one run measured: NUMBERS and the backend, or why it failed."""
        folder = os.path.join(self.out, "runs", sequence.name, f"{tracker}_{index + 1}")
        shutil.rmtree(folder, ignore_errors=True)
        try:
            done = subprocess.run(self.command(sequence, tracker, folder), stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, text=True, errors="replace", check=False)
        except OSError as error:
            return {"failed": str(error)}
        if done.returncode != 0:
            said = done.stderr.strip().splitlines()
            reason = REASONS.get(done.returncode, f"ends with {done.returncode}")
            return {"failed": f"{reason}: {said[-1]}" if said else reason}
        try:
            with open(os.path.join(folder, "stats.json"), encoding="utf-8") as text:
                stats = json.load(text)
        except (OSError, ValueError) as error:
            return {"failed": f"stats.json: {error}"}
        numbers = {name: number_at(stats, path) for name, path in NUMBERS.items()}
        return numbers | {key: number_at(stats, ("gpu", key)) for key in ("backend", "renderer", "timer")}


def summary(runs):
    """The medians over the runs that did not fail; None for what no run has."""
    good = [run for run in runs if "failed" not in run]
    medians = {}
    for name in NUMBERS:
        values = [run[name] for run in good if run[name] is not None]
        medians[name] = statistics.median(values) if values else None
    backend = {key: good[0][key] if good else None for key in ("backend", "renderer", "timer")}
    failed = [run["failed"] for run in runs if "failed" in run]
    return {"runs": runs, "succeeded": len(good), "failed": failed, "median": medians} | backend


def measure(replayer, sequence, count, say):
    """Both trackers in turn, count times; a sequence that cannot be read is not tried again."""
    runs = {tracker: [] for tracker in TRACKERS}
    for index in range(count):
        for tracker in TRACKERS:
            say(f"{sequence.name}: {tracker}, run {index + 1} of {count}")
            runs[tracker].append(replayer.run(sequence, tracker, index))
        if all("failed" in run for of_tracker in runs.values() for run in of_tracker):
            break
    return {tracker: summary(of_tracker) for tracker, of_tracker in runs.items()}
