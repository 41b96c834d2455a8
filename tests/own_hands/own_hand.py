#!/usr/bin/env python3
"""Builds the profile of a hand in hands/ with nothing but its URDF, and checks what is said of it against truth.json beside
this file, which a person wrote; checks that its meshes are closed. A joint may be of either class when it is `ambiguous`."""

import argparse
import collections
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NORMAL_TOLERANCE = math.radians(10)  # that of the real hands' truth.json
MOST_TRIANGLES = 3000  # of a link


def angle(a, b):
    return math.acos(sum(x * y for x, y in zip(a, b, strict=True)) / (math.hypot(*a) * math.hypot(*b)))


class Anatomy(unittest.TestCase):
    bin: pathlib.Path  # folder of the built tools
    hand: str

    @classmethod
    def setUpClass(cls):
        cls.truth = json.loads(pathlib.Path(__file__).with_name("truth.json").read_text())[cls.hand]
        urdf = ROOT / "hands" / cls.hand / f"{cls.hand}.urdf"
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([cls.bin / "uhas-build-profile", urdf, "-o", pathlib.Path(folder) / "hand.h5", "--json"],
                                  capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(done.stderr)
        cls.stderr = done.stderr
        cls.summary = json.loads(done.stdout)
        cls.fingers = {finger["tip_link"]: finger for finger in cls.summary["fingers"]}

    def test_no_warning(self):
        self.assertEqual(self.summary["warnings"], [])
        self.assertEqual(self.stderr, "")

    def test_palm_and_handedness(self):
        self.assertEqual(self.summary["hand"], self.hand)
        self.assertEqual(self.summary["palm_link"], self.truth["palm_link"])
        self.assertEqual(self.summary["handedness"], self.truth["handedness"])
        self.assertLess(angle(self.summary["palm_normal_in_root"], self.truth["palm_normal_in_root"]), NORMAL_TOLERANCE)

    def test_fingers(self):
        self.assertEqual({tip: finger["slots"] for tip, finger in self.fingers.items()},
                         {finger["tip_link"]: finger["slots"] for finger in self.truth["fingers"]})
        for truth in self.truth["fingers"]:
            joints = self.fingers[truth["tip_link"]]["joints"]
            self.assertEqual([joint["name"] for joint in joints], truth["joints"])
            for joint in joints:
                if joint["name"] not in truth["ambiguous"]:
                    expected = "lateral" if joint["name"] in truth["lateral"] else "encompassing"
                    self.assertEqual(joint["class"], expected, joint["name"])

    def test_every_finger_has_surface_points(self):
        for tip, finger in self.fingers.items():
            self.assertGreater(finger["correspondences"], 100, tip)


class Meshes(unittest.TestCase):
    hand: str

    @classmethod
    def setUpClass(cls):
        paths = sorted((ROOT / "hands" / cls.hand / "meshes").iterdir())
        cls.meshes = {path.name: cls.read(path) for path in paths}

    @staticmethod
    def read(path):
        """(vertices, triangles) of an OBJ file."""
        lines = [line.split() for line in path.read_text().splitlines()]
        return ([tuple(map(float, words[1:])) for words in lines if words[0] == "v"],
                [tuple(int(word) - 1 for word in words[1:]) for words in lines if words[0] == "f"])

    def test_small(self):
        for name, (_, triangles) in self.meshes.items():
            self.assertLessEqual(len(triangles), MOST_TRIANGLES, name)

    def test_closed(self):
        for name, (_, triangles) in self.meshes.items():
            edges = collections.Counter((t[i], t[(i + 1) % 3]) for t in triangles for i in range(3))
            self.assertEqual(set(edges.values()), {1}, f"{name}: an edge is run through twice in one direction")
            self.assertTrue(all((b, a) in edges for a, b in edges), f"{name}: an edge has one side only")

    def test_normals_outward(self):
        for name, (vertices, triangles) in self.meshes.items():
            volume = 0
            for a, b, c in ([vertices[i] for i in t] for t in triangles):
                volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                           a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
            self.assertGreater(volume, 0, name)

    def test_one_piece(self):
        for name, (vertices, triangles) in self.meshes.items():
            neighbours = collections.defaultdict(set)
            for triangle in triangles:
                for vertex in triangle:
                    neighbours[vertex].update(triangle)
            reached, front = {0}, [0]
            while front:
                new = neighbours[front.pop()] - reached
                reached |= new
                front += new
            self.assertEqual(len(reached), len(vertices), f"{name}: the mesh has several parts")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    parser.add_argument("--hand", required=True, help="folder in hands/")
    arguments = parser.parse_args()
    Anatomy.bin = arguments.bin
    Anatomy.hand = Meshes.hand = arguments.hand
    unittest.main(argv=sys.argv[:1], verbosity=2)
