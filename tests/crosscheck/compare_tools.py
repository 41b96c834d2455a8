#!/usr/bin/env python3
"""Builds a hand's profile with uhas-build-profile, solves random actions with uhas-solve, and lets the second reader
(read_profile.py, lateral_and_weights.py) arrive at the same forward kinematics, lateral joints, residuals and weights."""

import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile

import numpy as np

import lateral_and_weights
import read_profile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import real_hand  # noqa: E402

SLOTS = 5
TOLERANCE = 1e-9  # radii, metres, radians
POINTS_PER_LINK = 32  # the default of uhas-build-profile


def random_actions(seed, V, normalized):
    """Actions of 5 + 5 V numbers: mild, beyond the bounds, strongly contracted, and all closed (as an object)."""
    draw = random.Random(seed)
    lateral, radius = (1, 0.5) if normalized else (0.6, 1)  # what stands for a wide turn, and for one sphere radius

    def numbers(low, high, count):
        return [draw.uniform(low, high) for _ in range(count)]

    mild = numbers(-lateral / 3, lateral / 3, SLOTS) + numbers(-0.3 * radius, 0.3 * radius, SLOTS * V)
    wide = numbers(-1.5 * lateral, 1.5 * lateral, SLOTS) + numbers(-2.5 * radius, 2.5 * radius, SLOTS * V)
    contracted = numbers(-lateral, lateral, SLOTS) + numbers(-1.2 * radius, -0.4 * radius, SLOTS * V)
    closed = {"lateral": numbers(-lateral, lateral, SLOTS), "radial": [[-2.5 * radius] * V] * SLOTS}
    return [mild, wide, contracted, closed]


def random_angles(seed, V, planes):
    """V increasing polar angles for each of `planes` planes, within 15 degrees of the default ones."""
    draw = random.Random(seed)
    spread = min(np.pi / 12, np.pi / (2 * V + 3))
    return [np.pi * j / (V + 1) + draw.uniform(-spread, spread) for _ in range(planes) for j in range(1, V + 1)]


def action_files():
    """(label, actions document, options of uhas-solve): every V in every form."""
    for V in range(1, 5):
        plain = {"format": "uhas-actions", "version": 1, "actions": random_actions(V, V, False)}
        normalized = dict(plain, normalized=True, actions=random_actions(10 + V, V, True))
        yield f"V = {V}", plain, []
        yield f"V = {V}, normalized", normalized, ["--passes", "3"]
        yield f"V = {V}, own angles", dict(plain, driving_vectors_phi=random_angles(V, V, 1)), ["--rule", "contact"]
        yield f"V = {V}, own angles a plane", dict(normalized, driving_vectors_phi=random_angles(V, V, SLOTS)), []


def compare_solutions(profile, run, folder):
    """Messages on residuals and lateral joints that differ; the number of residuals and how many of them do not exist."""
    messages, residuals = [], []
    for label, actions, options in action_files():
        (folder / "actions.json").write_text(json.dumps(actions))
        solution = run("uhas-solve", folder / "actions.json", "--profile", folder / "hand.h5", *options)
        messages += [f"{label}: {m}" for m in read_profile.compare_residuals(profile, solution, actions, TOLERANCE)]
        messages += [
            f"{label}: {m}"
            for m in lateral_and_weights.compare_lateral_joints(profile, solution, actions, TOLERANCE)
        ]
        residuals += [s["residual_rms"] for s in solution["solutions"]]
    missing = residuals.count(None)
    if not 0 < missing < len(residuals):
        messages.append(f"{missing} of {len(residuals)} solutions have no residual: the actions test too little")
    return messages, len(residuals), missing


def fingertips(profile, q):
    """[F, 3] fingertips in the palm's frame."""
    T_palm_link = read_profile.fk(profile, q)
    fingers, links = profile["fingers"], profile["links"]["name"]
    return np.array(
        [
            T_palm_link[links[link]][:3] @ np.append(p, 1)
            for link, p in zip(fingers["tip_link"], fingers["p_tip_link"])
        ]
    )


def compare_summary(profile, summary):
    """Messages on what uhas-inspect says of the sphere and the fingertips, at the open and at the wrapped pose."""
    T_root_palm, T_palm_sphere = profile["hand"]["T_root_palm"], profile["sphere"]["T_palm_sphere"]
    T_root_sphere = T_root_palm @ T_palm_sphere
    at_open = fingertips(profile, profile["joints"]["q_open"]) @ T_root_palm[:3, :3].T + T_root_palm[:3, 3]
    wrapped = (fingertips(profile, profile["joints"]["q_sphere"]) - T_palm_sphere[:3, 3]) @ T_palm_sphere[:3, :3]
    theta = np.arctan2(wrapped[:, 1], wrapped[:, 0]) * (-1 if profile["hand"]["mirrored"] else 1)
    phi = np.arccos(-wrapped[:, 2] / np.linalg.norm(wrapped, axis=1))

    def told(key):
        return np.array([finger[key] for finger in summary["fingers"]])

    differences = {
        "sphere.radius": summary["sphere"]["radius"] - profile["sphere"]["radius"],
        "sphere.center_in_root": summary["sphere"]["center_in_root"] - T_root_sphere[:3, 3],
        "sphere.rotation_in_root": summary["sphere"]["rotation_in_root"] - T_root_sphere[:3, :3],
        "tip_in_root_at_open": told("tip_in_root_at_open") - at_open,
        "theta_initial": (told("theta_initial") - theta + np.pi) % (2 * np.pi) - np.pi,
        "tip_phi": told("tip_phi") - phi,
    }
    for key, difference in differences.items():
        if not np.abs(difference).max() <= TOLERANCE:
            yield f"{key} differs by {np.abs(difference).max()}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    hand = parser.add_mutually_exclusive_group(required=True)
    hand.add_argument("--urdf", type=pathlib.Path)
    hand.add_argument("--hand", help="folder in UHAS_HANDS_DIR")
    arguments = parser.parse_args()
    urdf = arguments.urdf or real_hand.find_hand(arguments.hand)[1]

    def run(tool, *options):
        done = subprocess.run(
            [arguments.bin / tool, "--quiet", *map(str, options)], check=True, stdout=subprocess.PIPE, text=True
        )
        return json.loads(done.stdout) if done.stdout else None

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run("uhas-build-profile", urdf, "-o", folder / "hand.h5")
        profile = read_profile.load(folder / "hand.h5")
        messages = list(compare_summary(profile, run("uhas-inspect", folder / "hand.h5", "--json")))
        messages += lateral_and_weights.compare_tables(profile)
        messages += lateral_and_weights.compare_weights(profile, POINTS_PER_LINK)
        differences, count, missing = compare_solutions(profile, run, folder)
        messages += differences
    for message in messages:
        print(f"compare_tools.py: {urdf}: {message}", file=sys.stderr)
    print(f"{profile['hand']['name']}: {count} solutions, {missing} without residual, {len(messages)} differences")
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
