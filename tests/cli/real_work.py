"""One run of each tool that uses all of it that there is: options, formats and libraries. For tests of what a tool must not do."""
import json
import pathlib
import shutil

import h5py
import numpy as np

HAND = pathlib.Path(__file__).resolve().parents[2] / "hands" / "allegro_right"
JOINTS = [f"{finger}_joint_{i}" for finger in ("index", "middle", "ring", "thumb") for i in range(4)]
ACTION = [0, 0, 0, 0.2, 0, 0, 0, 0, 0, 0, 0, -0.3, -0.3, 0, 0]


def write_input(folder):
    """hand.urdf with its meshes, actions.json, and a trajectory as t.json and t.h5, in `folder`."""
    shutil.copytree(HAND, folder, dirs_exist_ok=True)
    (folder / "allegro_right.urdf").rename(folder / "hand.urdf")
    (folder / "actions.json").write_text(json.dumps({"format": "uhas-actions", "version": 1, "profile": "hand.h5",
                                                     "actions": [ACTION, ACTION]}))
    trajectory = {"format": "uhas-trajectory", "version": 1, "hand": "allegro_right", "joint_names": JOINTS, "q": [[0.4] * 16] * 3}
    (folder / "t.json").write_text(json.dumps(trajectory))
    with h5py.File(folder / "t.h5", "w") as file:
        file["q"] = trajectory["q"]
        file["joint_names"] = np.array(JOINTS, "S16")


def commands(folder):
    """Run one after another, each succeeds; what they print is JSON, what they write is named out.* or hand.h5."""
    at = str(folder) + "/"
    urdf, profile = at + "hand.urdf", at + "hand.h5"
    stages = ["explain-hand", "sphere-frame", "project-surface", "classify-joints", "lateral-tables"]
    return [
        ["uhas-build-profile", urdf, "-o", profile, "--write-config", at + "out.config.json", "--json"],
        ["uhas-build-profile", urdf, "-o", at + "out.h5", "--config", at + "out.config.json", "--json"],
        *[[f"uhas-{stage}", urdf, "--json"] for stage in stages],
        ["uhas-solve", at + "actions.json", "-o", at + "out.solution.json", "--html", at + "out.solution.html", "--collisions",
         "--avoid", "--urdf", urdf],
        ["uhas-retarget", "--from", profile, "--to", profile, at + "t.json", "-o", at + "out.trajectory.json", "--json"],
        ["uhas-retarget", "--from", profile, "--to", profile, at + "t.h5", "-o", at + "out.trajectory.h5", "--json"],
        ["uhas-evaluate", profile, at + "out.h5", "--actions", "20", "--lines", "5", "--html", at + "out.evaluation.html", "--json"],
        ["uhas-inspect", profile, "--json"],
        ["uhas-inspect", profile, "--validate", "--check", urdf, "--json"],
        ["uhas-inspect", profile, "--html", at + "out.report.html", "--gltf", at + "out.glb", "--ply", at + "out.ply",
         "--svg", at + "out.svg", "--quiet"],
        ["uhas-inspect", at + "out.h5", "--reseal", "--json"],
    ]
