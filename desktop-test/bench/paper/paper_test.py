"""The paper's tables: which folders are found, which figures stand beside ours, and how failures show."""
import contextlib
import io
import json
import os
import stat
import tempfile
import unittest

import figures
import paper
import sequences
import tables

STATS = {
    "time_ms": {"update": {"median": 4.0}}, "direct_share": 0.5, "tracked_ratio": 1.0,
    "gpu": {"backend": "cpu", "renderer": None, "timer": "cpu", "pre_ms": {"median": 1.5}, "trk_ms": {"median": 2.5}},
    "accuracy": {"ate_rmse_m": 0.0123}, "frames": {"in": 300, "dropped": 7},
}
# Stands for glide-replay: refuses folders named broken, is twice as slow without the direct tracker.
REPLAY = """#!/usr/bin/env python3
import json, os, sys
source, arguments = sys.argv[1], dict(zip(sys.argv[2::2], sys.argv[3::2]))
if "broken" in source:
    sys.exit(print("glide replay: rgb.txt: is empty", file=sys.stderr) or 2)
stats = json.loads('''{stats}''')
if arguments["--tracker"] == "indirect":
    stats["time_ms"]["update"]["median"] = 8.0
    stats["gpu"]["pre_ms"] = stats["direct_share"] = None
os.makedirs(arguments["--output"])
with open(os.path.join(arguments["--output"], "stats.json"), "w") as out:
    json.dump(stats, out)
"""


def touch(*parts):
    path = os.path.join(*parts)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8"):
        pass


class InTemporaryFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = os.path.join(folder.name, "data")


class Finder(InTemporaryFolder):
    def found(self):
        return [(s.name, s.kind, s.patch, s.paper) for s in sequences.find([self.root])]

    def test_tells_the_papers_sequences_by_their_folders(self):
        for name in ("rgbd_dataset_freiburg3_long_office_household", "rgbd_dataset_freiburg2_desk",
                     "rgbd_dataset_freiburg2_xyz"):
            touch(self.root, "tum", name, "rgb.txt")
        for name in ("MH_01_easy", "MH_03_medium", "MH_05_difficult"):
            touch(self.root, "euroc", "machine_hall", name, "mav0", "cam0", "data.csv")
        self.assertEqual(self.found(), [
            ("rgbd_dataset_freiburg3_long_office_household", "tum", 7, "tum3"),
            ("rgbd_dataset_freiburg2_desk", "tum", 7, "tum2_desk"),
            ("rgbd_dataset_freiburg2_xyz", "tum", 7, "tum2_xyz"),
            ("MH_01_easy", "euroc", 11, "MH01"),
            ("MH_03_medium", "euroc", 11, "MH03"),
            ("MH_05_difficult", "euroc", 11, "MH05"),
        ])

    def test_takes_other_datasets_for_what_they_are(self):
        touch(self.root, "rgbd_dataset_freiburg2_desk_with_person", "rgb.txt")
        touch(self.root, "V1_01_easy", "mav0", "cam0", "data.csv")
        touch(self.root, "MH_12_made_up", "cam0", "data.csv")
        touch(self.root, "photos", "1.png")
        self.assertEqual([(name, key) for name, _, _, key in self.found()],
                         [("MH_12_made_up", None), ("V1_01_easy", None),
                          ("rgbd_dataset_freiburg2_desk_with_person", None)])

    def test_finds_a_folder_once_however_it_is_named(self):
        touch(self.root, "euroc_MH01_5s-21s", "mav0", "cam0", "data.csv")
        sequence = os.path.join(self.root, "euroc_MH01_5s-21s")
        found = sequences.find([self.root, sequence, sequence + "/"])
        self.assertEqual([(s.name, s.paper) for s in found], [("euroc_MH01_5s-21s", "MH01")])


class Figures(unittest.TestCase):
    def test_are_those_of_the_paper(self):
        self.assertEqual(figures.SEQUENCES, ("tum3", "tum2_desk", "tum2_xyz", "MH01", "MH03", "MH05"))
        self.assertEqual(figures.FRAME_MS["tum3"], ((9.6, 5.0), (31.1, 4.8), (131.0, 58.8)))
        self.assertEqual(figures.FRAME_MS["MH03"], ((9.9, 11.9), (33.4, 32.6), (135.0, 180.5)))
        self.assertEqual(figures.GPU_MS["MH05"], ((1.1, 1.9), (2.8, 3.8), (67.3, 45.7)))
        self.assertEqual(figures.DIRECT_PERCENT["tum2_xyz"], (89.9, 89.8, 89.8))
        self.assertEqual(figures.ATE_M["MH05"], ((0.056, 0.075), (0.051, 0.053), (0.037, 0.048)))

    def test_sum_to_what_was_copied(self):
        def total(table):
            cells = [cell for row in table.values() for cell in row]
            return sum(sum(cell) if isinstance(cell, tuple) else cell for cell in cells)

        self.assertAlmostEqual(total(figures.FRAME_MS), 1707.9, places=6)
        self.assertAlmostEqual(total(figures.GPU_MS), 664.5, places=6)
        self.assertAlmostEqual(total(figures.DIRECT_PERCENT), 1199.1, places=6)
        self.assertAlmostEqual(total(figures.ATE_M), 0.964, places=6)

    def test_speed_ups_are_the_papers(self):
        cells = tables.pairs(figures.FRAME_MS["tum2_desk"], "{:.1f}", with_ratio=True)
        self.assertEqual(cells, ["9.9 / 5.1, 1.9 x", "32.8 / 3.6, 9.1 x", "132.0 / 64.3, 2.1 x"])


class Program(InTemporaryFolder):
    def run_main(self, *arguments):
        replay = os.path.join(os.path.dirname(self.root), "replay")
        with open(replay, "w", encoding="utf-8") as out:
            out.write(REPLAY.replace("{stats}", json.dumps(STATS)))
        os.chmod(replay, stat.S_IRWXU)
        out = os.path.join(os.path.dirname(self.root), "out")
        with contextlib.redirect_stdout(io.StringIO()) as stdout, contextlib.redirect_stderr(io.StringIO()):
            status = paper.main([self.root, "--out", out, "--replay", replay, *arguments])
        return status, stdout.getvalue(), out

    def test_prints_ours_beside_the_papers(self):
        touch(self.root, "fr2_desk", "rgb.txt")
        status, text, out = self.run_main("--runs", "2")
        self.assertEqual(status, 0)
        self.assertIn("| fr2_desk (307 frames of tum2_desk) | 8.00 | 4.00 | 2.0 x | 9.9 / 5.1, 1.9 x |", text)
        self.assertIn("| 1.50 | 2.50 | cpu | 2.5 / 3.6 | 2.1 / 2.8 | 43.7 / 38.9 |", text)
        self.assertIn("| 50.0 | 70.1 | 70.3 | 69.2 |", text)
        self.assertIn("| 0.0123 | 0.0123 | 0.008 / 0.010 | 0.013 / 0.008 | 0.006 / 0.016 |", text)
        with open(os.path.join(out, "paper.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["sequences"][0]["hybrid"]["median"]["frame_ms"], 4.0)

    def test_a_run_that_fails_is_a_row(self):
        touch(self.root, "broken", "rgb.txt")
        touch(self.root, "good", "rgb.txt")
        status, text, _ = self.run_main("--runs", "3", "--json")
        report = json.loads(text)
        broken = report["sequences"][0]
        self.assertEqual(status, 0)
        self.assertEqual(broken["hybrid"]["failed"], ["unreadable: glide replay: rgb.txt: is empty"])
        self.assertIsNone(broken["hybrid"]["median"]["frame_ms"])
        self.assertIn("| broken | - | - | - |", tables.document(report))

    def test_nothing_to_replay_is_no_success(self):
        os.makedirs(self.root)
        self.assertEqual(self.run_main()[0], paper.NOTHING)
        touch(self.root, "broken", "rgb.txt")
        self.assertEqual(self.run_main()[0], paper.NOTHING)

    def test_wrong_usage_ends_with_1(self):
        os.makedirs(self.root)
        with self.assertRaises(SystemExit) as stop:
            self.run_main("--runs", "0")
        self.assertEqual(stop.exception.code, 1)


if __name__ == "__main__":
    unittest.main()
