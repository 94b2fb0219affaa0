#!/usr/bin/env python3
"""Runs the suites of docs/benchmarks.md that take minutes: loss, loops, repeated facades, blackouts.

usage: suites.py SUITE... [options]      SUITE: kidnap loops facades blackout
Renders into OUT/sequences (kept and reused), replays into OUT/runs and writes OUT/SUITE.json and OUT/SUITE.md.
The tables are printed as well. Exits with 1 when a suite does not reach its target.
"""
import argparse
import concurrent.futures
import json
import os
import sys

import cases
from tools import Failure, Tools

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.path.join(ROOT, "build", "release", "desktop-test")


def at_least(rows, key, share):
    count = sum(bool(row.get(key)) for row in rows)
    return count >= share * len(rows), f"{key} in {count} of {len(rows)}"


def judge_kidnap(rows):
    reached, text = at_least(rows, "ok", 0.9)
    wrong = sum(bool(row.get("wrong")) for row in rows)
    return reached and wrong == 0, f"relocalised within {cases.RELOCALISED_WITHIN} frames: {text}; wrong: {wrong}"


def judge_loops(rows):
    found, text = at_least(rows, "ok", 0.9)
    worst = max((row.get("ratio") or 9.0 for row in rows if row.get("ok")), default=9.0)
    return found and worst <= 1.0 / 3.0, f"loop found: {text}; worst ATE ratio of these: {worst:.2f}"


def judge_facades(rows):
    reached, text = at_least(rows, "ok", 1.0)
    loops = sum(row.get("loops closed", 0) for row in rows)
    wrong = sum(row.get("tracked but wrong", 0) for row in rows)
    return reached, f"{text}; false loops: {loops}; frames tracked more than {cases.BRICK_M} m off: {wrong}"


def judge_all(rows):
    return at_least(rows, "ok", 1.0)


SUITES = {
    "kidnap": (cases.kidnap, list(range(1, 21)), judge_kidnap),
    "loops": (cases.loops, list(range(1, 11)), judge_loops),
    "facades": (cases.facades, list(range(1, 11)), judge_facades),
    "blackout": (cases.blackout, list(cases.REAL), judge_all),
}


def cell(value):
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def table(rows):
    columns = list(dict.fromkeys(key for row in rows for key in row))
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    lines += ["| " + " | ".join(cell(row.get(column)) for column in columns) + " |" for row in rows]
    return "\n".join(lines)


def run_case(case, tools, seed):
    try:
        return case(tools, seed)
    except (Failure, ValueError) as reason:
        return {"seed": seed, "failed": str(reason).splitlines()[0]}


def run_suite(name, tools, options):
    case, seeds, judge = SUITES[name]
    if options.seeds and isinstance(seeds[0], int):
        seeds = options.seeds
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        rows = list(pool.map(lambda seed: run_case(case, tools, seed), seeds))
    reached, verdict = judge(rows)
    text = f"## {name}\n\n{table(rows)}\n\n{'reached' if reached else 'NOT REACHED'}: {verdict}\n"
    print(text, flush=True)
    with open(os.path.join(tools.out, f"{name}.md"), "w", encoding="utf-8") as out:
        out.write(text)
    with open(os.path.join(tools.out, f"{name}.json"), "w", encoding="utf-8") as out:
        json.dump({"suite": name, "reached": reached, "verdict": verdict, "rows": rows}, out, indent=1)
    return reached


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("suites", nargs="+", choices=sorted(SUITES), metavar="SUITE")
    parser.add_argument("--seeds", type=lambda text: [int(x) for x in text.split(",")], help="for instance 1,2,3")
    parser.add_argument("--jobs", type=int, default=1, help="sequences at a time")
    parser.add_argument("--reuse", action="store_true", help="evaluate the runs that are there again")
    parser.add_argument("--out", default=os.path.join(ROOT, "out", "suites"))
    parser.add_argument("--synth", default=os.path.join(BUILD, "synthetic", "glide-synth"))
    parser.add_argument("--replay", default=os.path.join(BUILD, "replay", "glide-replay"))
    parser.add_argument("--data", default=os.path.join(ROOT, "..", "shared", "data"))
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)
    tools = Tools(options)
    return 0 if all([run_suite(name, tools, options) for name in options.suites]) else 1


if __name__ == "__main__":
    sys.exit(main())
