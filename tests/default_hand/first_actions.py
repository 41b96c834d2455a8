#!/usr/bin/env python3
"""Solves examples/first_actions.json on hands/allegro_right with the built tools and checks what a person would expect."""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
ACTIONS = ROOT / "examples/first_actions.json"
INDEX_SLOT = 3
SLOTS, VECTORS = 5, 2


class FirstActions(unittest.TestCase):
    bin: pathlib.Path  # folder of the built tools

    @classmethod
    def tool(cls, name, *arguments, stdin=None):
        return subprocess.run([cls.bin / name, *arguments], input=stdin, capture_output=True, text=True, check=True).stdout

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.profile = pathlib.Path(cls.folder.name) / "allegro_right.h5"
        cls.tool("uhas-build-profile", ROOT / "hands/allegro_right/allegro_right.urdf", "-o", cls.profile)
        cls.hand = json.loads(cls.tool("uhas-inspect", cls.profile, "--json"))
        solution = json.loads(cls.tool("uhas-solve", ACTIONS, "--profile", cls.profile))
        cls.joint_names = solution["joint_names"]
        cls.solutions = solution["solutions"]
        cls.zero, cls.spread, cls.one_closed, cls.all_closed, cls.gentle = (cls.joints(s) for s in cls.solutions)
        cls.index = next(finger for finger in cls.hand["fingers"] if INDEX_SLOT in finger["slots"])

    @classmethod
    def joints(cls, solution):
        return dict(zip(cls.joint_names, solution["q"], strict=True))

    @classmethod
    def encompassing(cls, *fingers):
        return {j["name"] for finger in fingers for j in finger["joints"] if j["class"] == "encompassing"}

    def assert_joints(self, joints, expected, names, tolerance):
        for name in names:
            self.assertAlmostEqual(joints[name], expected[name], delta=tolerance, msg=name)

    def test_the_file_holds_the_five_actions_in_this_order(self):
        actions = json.loads(ACTIONS.read_text())["actions"]
        still, flat = [0] * SLOTS, [[0] * VECTORS] * SLOTS
        closed = [[-2] * VECTORS if slot == INDEX_SLOT else [0] * VECTORS for slot in range(SLOTS)]
        self.assertEqual(actions, [
            {"lateral": still, "radial": flat},
            {"lateral": [0.2 if slot == INDEX_SLOT else 0 for slot in range(SLOTS)], "radial": flat},
            {"lateral": still, "radial": closed},
            {"lateral": still, "radial": [[-2] * VECTORS] * SLOTS},
            {"lateral": still, "radial": [[-0.3] * VECTORS] * SLOTS},
        ])

    def test_zero_is_the_hand_on_the_sphere(self):
        self.assert_joints(self.zero, self.hand["q_sphere"], self.joint_names, 1e-9)

    def test_a_spread_moves_its_own_finger_only_and_its_lateral_joint_most(self):
        moved = {name: abs(self.spread[name] - self.zero[name]) for name in self.joint_names}
        own = {joint["name"] for joint in self.index["joints"]}
        for name in moved.keys() - own:
            self.assertEqual(moved[name], 0, name)
        self.assertEqual(max(moved, key=moved.get), self.index["lateral_joint"])
        self.assertGreater(moved[self.index["lateral_joint"]], 0.1)

    def test_one_closed_finger_leaves_the_others_alone(self):
        bent = self.encompassing(self.index)
        self.assert_joints(self.one_closed, self.hand["q_closed"], bent, 1e-6)
        for name in set(self.joint_names) - bent:
            self.assertEqual(self.one_closed[name], self.zero[name], name)
        self.assertEqual(set(self.solutions[2]["closed"]), bent)

    def test_all_closed_is_the_fist(self):
        bent = self.encompassing(*self.hand["fingers"])
        self.assert_joints(self.all_closed, self.hand["q_closed"], bent, 1e-6)
        self.assertEqual(set(self.solutions[3]["closed"]), bent)

    def test_a_gentle_contraction_bends_every_finger_towards_the_fist(self):
        def distance(joints, finger):  # to the closed pose
            return sum(abs(joints[name] - self.hand["q_closed"][name]) for name in self.encompassing(finger))

        for finger in self.hand["fingers"]:
            self.assertLess(distance(self.gentle, finger), distance(self.zero, finger) - 0.1, finger["name"])
        self.assertEqual(self.solutions[4]["closed"], [])

    def test_residuals_are_numbers_but_where_no_point_is_left(self):
        for number, solution in enumerate(self.solutions):
            residual = solution["residual_rms"]
            if number == 3:
                self.assertIsNone(residual)
            else:
                self.assertTrue(math.isfinite(residual) and 0 <= residual < 0.2, f"action {number}: {residual}")

    def test_the_hand_closes_without_a_jump(self):
        steps = [max(-2, -0.03 * k) for k in range(68)]  # 0, -0.03, .. -2
        stream = "".join(json.dumps([0] * SLOTS + [radial] * SLOTS * VECTORS) + "\n" for radial in steps)
        lines = self.tool("uhas-solve", "-", "--profile", self.profile, stdin=stream).splitlines()
        sweep = [self.joints(json.loads(line)) for line in lines]
        self.assertEqual(len(sweep), len(steps))
        self.assertEqual(sweep[0], self.zero)
        self.assertEqual(sweep[-1], self.all_closed)
        for radial, before, after in zip(steps[1:], sweep, sweep[1:]):
            for name in self.joint_names:
                self.assertLess(abs(after[name] - before[name]), 0.35, f"{name} at a radial displacement of {radial:.2f}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    FirstActions.bin = parser.parse_args().bin
    unittest.main(argv=sys.argv[:1], verbosity=2)
