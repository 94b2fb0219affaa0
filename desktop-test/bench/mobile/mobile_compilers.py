#!/usr/bin/env python3
"""Compiles every shader variant for mobile GPUs that are not there, and judges what the compilers made of it.

usage: mobile_compilers.py --cache FOLDER [--shaders GLOB] [--gpu NAME]... [--json]
Prints tables (or JSON), writes out/bench/mobile_compilers.json and, when all shaders went through all GPUs, the tables
in docs/benchmarks.md. Exits with 1 when a shader does not compile or a check is broken.
"""
import argparse
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import sys

import checks
import driver_output
import gpus
import report

ROOT = pathlib.Path(__file__).resolve().parents[3]


@dataclasses.dataclass
class Result:
    gpu: gpus.Gpu
    renderer: str
    variants: list
    errors: list
    costs: dict


def measure(gpu, cache, glob):
    renderer, variants, errors = driver_output.read(gpus.compile_shaders(gpu, cache, glob))
    costs = checks.loop_costs(gpu, variants)
    for variant in variants:
        variant.listing = []  # megabytes
    print(f"{gpu.name}: {len(variants)} variants", file=sys.stderr)
    return Result(gpu, renderer, variants, errors, costs)


def measure_all(chosen, arguments):
    """As many at a time as there are cores; Midgard's compiler, which takes as long as all others, begins first."""
    slow_first = sorted(chosen, key=lambda gpu: gpu.compiler != "midgard")
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        results = list(pool.map(lambda gpu: measure(gpu, arguments.cache, arguments.shaders), slow_first))
    return sorted(results, key=lambda result: chosen.index(result.gpu))


def compile_errors(results):
    """What failed, and on which GPUs."""
    where = {}
    for result in results:
        for error in result.errors:
            where.setdefault(error, []).append(result.gpu.name)
    return [error if len(names) == len(results) else f"{', '.join(names)}: {error}" for error, names in where.items()]


def find_faults(results, all_shaders):
    faults = compile_errors(results)
    for result in results:
        faults += checks.check(result.gpu, result.variants, result.costs)
    if all_shaders and results:
        faults += checks.check_hot_kernels(results[0].variants)
    return faults


def parse_arguments():
    parser = argparse.ArgumentParser(prog="./glide bench mobile-compilers", description=__doc__.split("\n")[0])
    parser.add_argument("--cache", required=True, help=argparse.SUPPRESS)
    parser.add_argument("--shaders", default="*", metavar="GLOB", help="file names, for instance 'align_*'")
    parser.add_argument("--gpu", action="append", choices=[gpu.name for gpu in gpus.GPUS], help="may be repeated")
    parser.add_argument("--json", action="store_true", help="print JSON instead of tables")
    return parser.parse_args()


def write_docs(tables):
    page = ROOT / "docs/benchmarks.md"
    page.write_text(report.between_markers(page.read_text(), tables))


def main():
    arguments = parse_arguments()
    chosen = [gpu for gpu in gpus.GPUS if not arguments.gpu or gpu.name in arguments.gpu]
    results = measure_all(chosen, arguments)
    everything = arguments.shaders == "*" and not arguments.gpu
    faults = find_faults(results, arguments.shaders == "*")
    as_json, tables = report.as_json(results, faults), report.markdown(results, faults)
    out = ROOT / "out/bench/mobile_compilers.json"
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text(json.dumps(as_json, indent=1) + "\n")
    if everything:
        write_docs(tables)
    print(json.dumps(as_json, indent=1) if arguments.json else tables)
    for fault in faults:
        print(f"glide: broken: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
