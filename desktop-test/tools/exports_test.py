#!/usr/bin/env python3
"""Tests what the converters share, and to_rerun.py against a module that records its calls."""
import contextlib
import importlib
import io
import math
import pathlib
import sys
import tempfile
import types
import unittest
from unittest import mock

import colors
import replay_images
import replay_run
import sample_run
import similarity


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_of_sample(self):
        return replay_run.read_run(sample_run.write(self.folder))


class Reading(InFolder):
    def test_keeps_times_to_the_nanosecond(self):
        run = self.run_of_sample()
        self.assertEqual([pose.t_ns for pose in run.trajectory], [sample_run.time(i) for i in (0, 2, 3, 4)])
        self.assertEqual(replay_run.nanoseconds("12"), 12_000_000_000)
        self.assertEqual(replay_run.nanoseconds("-0.5"), -500_000_000)

    def test_reads_the_map_with_its_colours(self):
        self.assertEqual(self.run_of_sample().landmarks[1], replay_run.Vertex((-1.0, 0.0, 5.0), (255, 0, 128), 300))

    def test_refuses_another_kind_of_ply(self):
        self.run_of_sample()
        ply = self.folder / "map.ply"
        ply.write_bytes(ply.read_bytes().replace(b"uchar green", b"uchar alpha"))
        with self.assertRaisesRegex(ValueError, "map.ply"):
            replay_run.read_run(self.folder)

    def test_brings_the_truth_into_the_world_of_the_trajectory(self):
        run = self.run_of_sample()
        self.assertEqual(len(run.truth), 5)
        for i, pose in enumerate(run.truth):
            for a, b in zip(pose.position, sample_run.position(i)):
                self.assertAlmostEqual(a, b, places=6)

    def test_does_without_a_truth(self):
        sample_run.write(self.folder)
        (self.folder / "groundtruth.tum").unlink()
        self.assertEqual(replay_run.read_run(self.folder).truth, [])

    def test_breaks_the_trajectory_where_the_camera_was_lost(self):
        [(poses, of_points)] = colors.strips(self.run_of_sample())  # one frame alone is no line
        self.assertEqual([pose.t_ns for pose in poses], [sample_run.time(i) for i in (2, 3, 4)])
        self.assertEqual(of_points, [colors.INDIRECT, colors.DIRECT, colors.DIRECT])


class Similarity(unittest.TestCase):
    def test_finds_what_moved_the_points(self):
        half = math.radians(25)
        axis = (0.6, 0.0, 0.8)
        true = similarity.Similarity(0.3, (*(math.sin(half) * v for v in axis), math.cos(half)), (4.0, -5.0, 6.0))
        points = [(0, 0, 0), (1, 0, 0.5), (0, 2, 0), (0.3, 0.1, 3), (-1, 1, 1)]
        found = similarity.align(points, [true.point(p) for p in points])
        for point in points:
            for a, b in zip(found.point(point), true.point(point)):
                self.assertAlmostEqual(a, b, places=9)

    def test_needs_points_in_more_than_one_place(self):
        self.assertIsNone(similarity.align([(1, 1, 1)] * 5, [(2, 2, 2)] * 5))
        self.assertIsNone(similarity.align([(0, 0, 0), (1, 0, 0)], [(0, 0, 0), (1, 0, 0)]))


class Images(InFolder):
    def setUp(self):
        super().setUp()
        self.run_of([sample_run.time(i) for i in range(3)])

    def run_of(self, times):
        frames = [replay_run.Frame(i, time, "tracking", "direct", {}) for i, time in enumerate(times)]
        self.replay = types.SimpleNamespace(frames=frames, source_frames=3)

    def names(self):
        return [path.name for path in replay_images.find(self.folder, self.replay).values()]

    def test_are_found_by_names_that_are_times(self):
        sample_run.write_images(self.folder)
        self.assertEqual(self.names(), [f"{frame.t_ns}.png" for frame in self.replay.frames])

    def test_are_found_by_the_lists_of_datasets(self):
        (self.folder / "rgb").mkdir()
        (self.folder / "rgb/a.png").write_bytes(b"")
        (self.folder / "rgb.txt").write_text(f"# time file\n{sample_run.seconds(sample_run.time(1))} rgb/a.png\n")
        self.assertEqual(self.names(), ["a.png"])

    def test_are_taken_in_natural_order_otherwise(self):
        self.run_of([0, 33_333_333, 66_666_667])
        for name in ("img10.png", "img2.png", "img1.png", "notes.txt"):
            (self.folder / name).write_bytes(b"")
        self.assertEqual(self.names(), ["img1.png", "img2.png", "img10.png"])
        self.run_of([0, 33_333_333])  # interrupted
        self.assertEqual(self.names(), ["img1.png", "img2.png"])

    def test_are_refused_where_order_does_not_tell_which_is_which(self):
        for name in ("1.png", "2.png", "3.png"):
            (self.folder / name).write_bytes(b"")
        self.run_of([0, 66_666_667])  # the second could not be decoded
        self.replay.frames.append(replay_run.Frame(2, 100_000_000, "tracking", "direct", {}))
        with self.assertRaisesRegex(ValueError, "left images out"):
            self.names()
        self.run_of([66_666_667, 100_000_000])  # --start
        with self.assertRaisesRegex(ValueError, "left images out"):
            self.names()
        (self.folder / "4.png").write_bytes(b"")  # --stride
        self.run_of([0, 66_666_667])
        with self.assertRaisesRegex(ValueError, "4 PNG.* took 3"):
            self.names()


class Rerun(InFolder):
    """With a module that writes down what it is called with; the real one is 170 MB."""

    def convert(self):
        self.calls = []
        fake = types.ModuleType("rerun")
        for name in ("Points3D", "LineStrips3D", "Pinhole", "Transform3D", "Quaternion", "EncodedImage", "Scalars",
                     "TextLog"):
            setattr(fake, name, lambda *args, _name=name, **options: (_name, args, options))
        fake.ViewCoordinates = types.SimpleNamespace(RDF="RDF")
        for name in ("init", "save", "set_time", "log"):
            setattr(fake, name, lambda *args, _name=name, **options: self.calls.append((_name, args, options)))
        with mock.patch.dict(sys.modules, rerun=fake):
            sys.modules.pop("to_rerun", None)
            to_rerun = importlib.import_module("to_rerun")
        sample_run.write(self.folder)
        images = sample_run.write_images(self.folder)
        arguments = ["to_rerun.py", str(self.folder), str(self.folder / "a.rrd"), "--images", str(images)]
        with mock.patch.object(sys, "argv", arguments), contextlib.redirect_stdout(io.StringIO()) as text:
            to_rerun.main()
        self.assertIn("4 poses, 2 landmarks, 5 images", text.getvalue())

    def logged(self, path):
        return [args[1] for name, args, _ in self.calls if name == "log" and args[0] == path]

    def test_gets_the_map_the_camera_and_the_curves(self):
        self.convert()
        [(_, args, options)] = self.logged("world/landmarks")
        self.assertEqual((args, options), (([(1, 2, 3), (-1, 0, 5)],), {"colors": [(10, 20, 30), (255, 0, 128)]}))
        kinds = [kind for kind, *_ in self.logged("world/camera")]
        self.assertEqual((kinds.count("Pinhole"), kinds.count("Transform3D"), kinds.count("EncodedImage")), (1, 4, 5))
        self.assertEqual([args for _, args, _ in self.logged("stats/inliers")], [(90.0 + i,) for i in range(5)])
        [(_, [strips], options)] = self.logged("world/trajectory")
        self.assertEqual([len(strip) for strip in strips], [3])
        self.assertEqual(options["colors"], [colors.DIRECT])

    def test_gets_times_since_the_start(self):
        self.convert()
        times = [options["duration"] for name, args, options in self.calls if name == "set_time" and args == ("time",)]
        for i, time in enumerate(times):
            self.assertAlmostEqual(time, i, places=6)


if __name__ == "__main__":
    unittest.main()
