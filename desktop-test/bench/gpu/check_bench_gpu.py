#!/usr/bin/env python3
"""Runs glide-gpu-bench on small images and holds it to the shape of its JSON, its exit statuses and its claims.

usage: check_bench_gpu.py PROGRAM      exit status: 0 ok, 1 not, 77 without OpenGL ES (1 when GLIDE_REQUIRE_GL=1)
"""
import json
import os
import subprocess
import sys
import unittest

SMALL = ["--size", "160x120", "--points", "60", "--patch", "5", "--levels", "3", "--frames", "3"]
STAGES = ["upload_ms", "pyramid_ms", "precompute_ms", "track_ms", "readback_ms"]
USAGE, NO_GL, SKIP = 1, 3, 77
PROGRAM = ""


def run(*arguments, **environment):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False,
                          env=os.environ | environment)


class Json(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.done = run(*SMALL, "--json")
        if cls.done.returncode != 0:
            raise AssertionError(cls.done.stderr)
        cls.report = json.loads(cls.done.stdout)

    def test_has_exactly_the_keys_of_its_contract(self):
        self.assertEqual(list(self.report), ["gpu", "plans", "pose_difference"])
        self.assertEqual(list(self.report["gpu"]), ["vendor", "renderer", "version", "timer"])
        self.assertEqual(list(self.report["plans"]), ["paper", "fused"])
        for plan in self.report["plans"].values():
            self.assertEqual(list(plan), STAGES + ["dispatches", "barriers", "bytes"])
            for stage in STAGES:
                self.assertEqual(list(plan[stage]), ["median", "p95"])

    def test_measures_every_stage(self):
        self.assertIn(self.report["gpu"]["timer"], ("query", "sync"))
        for plan in self.report["plans"].values():
            for stage in STAGES:
                self.assertGreater(plan[stage]["median"], 0.0)
                self.assertGreaterEqual(plan[stage]["p95"], plan[stage]["median"])
            for count in ("dispatches", "barriers", "bytes"):
                self.assertIsInstance(plan[count], int)
                self.assertGreater(plan[count], 0)

    def test_plans_agree_without_robust_weights(self):
        self.assertLess(self.report["pose_difference"], 1e-4)

    def test_the_paper_needs_three_dispatches_an_iteration_and_two_a_level(self):
        levels, iterations, upload = 3, 10, 1
        self.assertEqual(self.report["plans"]["paper"]["dispatches"], upload + 2 * (levels - 1) + 3 * iterations * levels)


class Program(unittest.TestCase):
    def test_one_plan_has_nothing_to_differ_from(self):
        report = json.loads(run(*SMALL, "--json", "--plan", "fused", "--timer", "fence").stdout)
        self.assertEqual(list(report["plans"]), ["fused"])
        self.assertIsNone(report["pose_difference"])
        self.assertEqual(report["gpu"]["timer"], "sync")

    def test_prints_tables_without_json(self):
        done = run(*SMALL)
        self.assertEqual(done.returncode, 0, done.stderr)
        for text in ("| track |", "paper / fused", "GB/s"):
            self.assertIn(text, done.stdout)

    def test_names_what_is_wrong_with_an_argument(self):
        for arguments in (("--size", "640"), ("--patch", "6"), ("--points", "3"), ("--plan", "best"), ("--frames", "0")):
            done = run(*arguments)
            self.assertEqual(done.returncode, USAGE, arguments)
            self.assertIn(arguments[0], done.stderr)

    def test_says_that_there_is_no_gl(self):
        done = run(*SMALL, GLIDE_NO_DRIVER="1", __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent.json")
        self.assertEqual(done.returncode, NO_GL)
        self.assertIn("OpenGL ES", done.stderr)


def main():
    global PROGRAM
    PROGRAM = sys.argv.pop(1)
    probe = run(*SMALL, "--frames", "1", "--plan", "fused")
    if probe.returncode == NO_GL:
        print(probe.stderr)
        return 1 if os.environ.get("GLIDE_REQUIRE_GL") == "1" else SKIP
    return 0 if unittest.main(exit=False).result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
