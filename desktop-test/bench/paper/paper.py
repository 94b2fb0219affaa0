#!/usr/bin/env python3
"""Replays the paper's sequences, and others, and prints its four tables with its figures beside ours.

Looks under the ROOTs for TUM RGB-D and EuRoC folders (the paper's are told by their names), replays each with the
hybrid tracker and with the indirect one alone, and writes OUT/paper.md and OUT/paper.json. A run that fails is a row
of the table. Exit status: 0 ok, 1 usage, 2 no sequence found or none that could be replayed.
"""
import argparse
import json
import os
import platform
import sys

import figures
import replays
import sequences
import tables

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
REPLAY = os.path.join(ROOT, "build", "release", "desktop-test", "replay", "glide-replay")
USAGE, NOTHING = 1, 2



class Parser(argparse.ArgumentParser):
    """Wrong usage ends with 1, as everywhere in ./glide."""

    def error(self, message):
        self.print_usage(sys.stderr)
        self.exit(USAGE, f"{self.prog}: {message}\n")


def positive(text):
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} is less than 1")
    return value


def folder(text):
    if not os.path.isdir(text):
        raise argparse.ArgumentTypeError(f"{text} is no folder")
    return text


def parse(arguments):
    parser = Parser(prog="glide bench paper", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roots", nargs="+", metavar="ROOT", type=folder)
    parser.add_argument("--runs", type=positive, default=5, help="of each sequence and tracker (default: 5)")
    parser.add_argument("--backend", choices=("auto", "gles", "cpu"), default="auto",
                        help="of the direct tracker; auto: gles on hardware GL, else cpu (default: auto)")
    parser.add_argument("--levels", type=positive, default=6, help="of the pyramid (default: 6)")
    parser.add_argument("--json", action="store_true", help="JSON on stdout instead of Markdown")
    parser.add_argument("--out", default=os.path.join(ROOT, "out", "bench", "paper"), help="default: out/bench/paper")
    parser.add_argument("--replay", default=REPLAY, help=argparse.SUPPRESS)
    return parser.parse_args(arguments)


def machine():
    """Processor and cores."""
    name = platform.machine()
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as text:
            name = next((line.split(":", 1)[1].strip() for line in text if line.startswith("model name")), name)
    except OSError:
        pass  # no Linux: the architecture must do
    return f"{os.cpu_count()} x {name}"


def say(text):
    print(f"glide bench paper: {text}", file=sys.stderr, flush=True)


def measure_all(found, options):
    replayer = replays.Replayer(options.replay, options.out, options)
    results = []
    for sequence in found:
        measured = replays.measure(replayer, sequence, options.runs, say)
        results.append({"name": sequence.name, "path": sequence.path, "paper": sequence.paper, "kind": sequence.kind,
                        "patch": sequence.patch} | measured)
    return {
        "machine": machine(),
        "options": {"runs": options.runs, "levels": options.levels, "backend": options.backend, "pace": "realtime"},
        "sequences": results,
        "paper": figures.as_json(),
    }


def main(arguments):
    options = parse(arguments)
    found = sequences.find(options.roots)
    if not found:
        say(f"no TUM RGB-D or EuRoC folder under {', '.join(options.roots)}")
        return NOTHING
    os.makedirs(options.out, exist_ok=True)
    report = measure_all(found, options)
    texts = {"json": json.dumps(report, indent=1) + "\n", "md": tables.document(report)}
    for ending, text in texts.items():
        with open(os.path.join(options.out, f"paper.{ending}"), "w", encoding="utf-8") as out:
            out.write(text)
    print(texts["json" if options.json else "md"], end="")
    succeeded = sum(result[tracker]["succeeded"] for result in report["sequences"] for tracker in replays.TRACKERS)
    return 0 if succeeded else NOTHING


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
