#!/usr/bin/env python3
"""Turns what ./glide bench measured into Markdown.

usage: bench_report.py FOLDER   (bench.json, hybrid/stats.json, indirect/stats.json)
"""
import json
import pathlib
import platform
import sys

STAGES = ("pyramid", "precompute", "align", "features", "match", "pose")


def row(*cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def milliseconds(value):
    return "-" if value is None else f"{value:.2f}"


def benchmark_table(report):
    """One line per micro-benchmark."""
    lines = [row("benchmark", "time", "CPU", "unit"), row("---", "---:", "---:", "---")]
    for run in report["benchmarks"]:
        if run.get("error_occurred"):
            lines.append(row(run["name"], run["error_message"], "", ""))
        elif run.get("run_type") != "aggregate":
            lines.append(row(run["name"], f"{run['real_time']:.3f}", f"{run['cpu_time']:.3f}", run["time_unit"]))
    return lines


def stage_table(folder):
    """Median and 95th percentile per stage of both replays, milliseconds."""
    runs = {name: json.loads((folder / name / "stats.json").read_text()) for name in ("hybrid", "indirect")}
    lines = [row("stage, ms", *(f"{name} {kind}" for name in runs for kind in ("median", "p95")))]
    lines.append(row("---", *["---:"] * 4))

    def add(label, pick):
        times = [pick(run["time_ms"]) or {} for run in runs.values()]
        lines.append(row(label, *(milliseconds(time.get(kind)) for time in times for kind in ("median", "p95"))))

    add("whole update", lambda time: time["update"])
    add("direct frames", lambda time: time["direct"])
    add("indirect frames", lambda time: time["indirect"])
    for stage in STAGES:
        add(stage, lambda time, stage=stage: time["stages"][stage])
    return lines


def main():
    folder = pathlib.Path(sys.argv[1])
    report = json.loads((folder / "bench.json").read_text())
    context = report["context"]
    print(f"# Benchmarks\n\n{context['date']}, {context['num_cpus']} x {context['mhz_per_cpu']} MHz, {platform.machine()}\n")
    print("## Micro-benchmarks\n\n" + "\n".join(benchmark_table(report)) + "\n")
    print("## Stages, synthetic room, 300 frames 640x480\n\n" + "\n".join(stage_table(folder)))


if __name__ == "__main__":
    main()
