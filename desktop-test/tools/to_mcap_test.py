#!/usr/bin/env python3
"""Tests to_mcap.py: the file is read back with the mcap library."""
import base64
import contextlib
import io
import json
import pathlib
import struct
import sys
import tempfile
import unittest
from unittest import mock

from mcap.reader import make_reader

import foxglove
import sample_run
import similarity
import to_mcap


class ToMcap(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as name:
            folder = sample_run.write(name)
            arguments = ["to_mcap.py", str(folder), "--images", str(sample_run.write_images(folder))]
            with mock.patch.object(sys, "argv", arguments), contextlib.redirect_stdout(io.StringIO()) as cls.text:
                to_mcap.main()
            cls.topics, cls.times = {}, []
            with (pathlib.Path(name) / "run.mcap").open("rb") as file:
                for schema, channel, message in make_reader(file).iter_messages(log_time_order=False):
                    assert (schema.encoding, channel.message_encoding) == ("jsonschema", "json")
                    cls.schemas = {**getattr(cls, "schemas", {}), channel.topic: schema}
                    cls.topics.setdefault(channel.topic, []).append((message.log_time, json.loads(message.data)))
                    cls.times.append(message.log_time)

    def test_says_what_it_wrote(self):
        self.assertIn("4 poses, 2 landmarks, 5 images", self.text.getvalue())

    def test_has_every_topic_with_its_schema(self):
        counts = {topic: (self.schemas[topic].name, len(messages)) for topic, messages in self.topics.items()}
        self.assertEqual(counts, {
            "/tf_static": ("foxglove.FrameTransform", 1), "/tf": ("foxglove.FrameTransform", 4),
            "/map/landmarks": ("foxglove.PointCloud", 1), "/map/keyframes": ("foxglove.PosesInFrame", 1),
            "/map/trajectory": ("foxglove.SceneUpdate", 1), "/camera/pose": ("foxglove.PoseInFrame", 4),
            "/groundtruth/pose": ("foxglove.PoseInFrame", 5), "/stats": ("glide.FrameStats", 5),
            "/camera/calibration": ("foxglove.CameraCalibration", 5),
            "/camera/image": ("foxglove.CompressedImage", 5)})

    def test_messages_have_the_fields_of_their_schemas(self):
        for topic, messages in self.topics.items():
            properties = json.loads(self.schemas[topic].data).get("properties")
            for _, message in messages:
                self.assertEqual(set(message), set(properties or message), topic)

    def test_times_are_exact_and_in_order(self):
        self.assertEqual(self.times, sorted(self.times))
        for t_ns, message in self.topics["/camera/pose"]:
            stamp = message["timestamp"]
            self.assertEqual(stamp["sec"] * 10**9 + stamp["nsec"], t_ns)
        self.assertEqual(self.topics["/camera/pose"][1][0], sample_run.time(2))

    def test_the_cloud_unpacks_to_the_map(self):
        [(_, cloud)] = self.topics["/map/landmarks"]
        data, offsets = base64.b64decode(cloud["data"]), {f["name"]: f["offset"] for f in cloud["fields"]}
        self.assertEqual(len(data), 2 * cloud["point_stride"])
        second = data[cloud["point_stride"]:]
        self.assertEqual(struct.unpack_from("<3f", second, offsets["x"]), (-1.0, 0.0, 5.0))
        self.assertEqual(struct.unpack_from("<4B", second, offsets["red"]), (255, 0, 128, 255))
        self.assertEqual(struct.unpack_from("<i", second, offsets["observations"]), (300,))

    def test_the_world_stands_upright(self):
        [(_, upright)] = self.topics["/tf_static"]
        q = tuple(upright["rotation"][axis] for axis in "xyzw")
        self.assertEqual(q, foxglove.UPRIGHT_FROM_WORLD)
        for point, expected in (((0, 1, 0), (0, 0, -1)), ((0, 0, 1), (1, 0, 0))):  # down; forward
            for a, b in zip(similarity.rotate(q, point), expected):
                self.assertAlmostEqual(a, b)

    def test_images_and_lens_are_those_of_the_camera(self):
        _, image = self.topics["/camera/image"][3]
        self.assertEqual((base64.b64decode(image["data"]), image["format"]), (b"picture 3", "png"))
        _, lens = self.topics["/camera/calibration"][0]
        self.assertEqual((lens["distortion_model"], len(lens["D"]), lens["K"][2]), ("plumb_bob", 5, 31.5))


if __name__ == "__main__":
    unittest.main()
