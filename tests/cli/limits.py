#!/usr/bin/env python3
"""Every bound that an option sets: a file beyond it is refused by one line that names the option, the same file passes when the
option is raised to fit. Every --max option of every tool is tried.

    limits.py --bin build/dev/bin
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import h5py
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
HAND = HERE.parent.parent / "hands" / "allegro_right"
URDF = HAND / "allegro_right.urdf"
JOINTS = [f"{finger}_joint_{i}" for finger in ("index", "middle", "ring", "thumb") for i in range(4)]
FRAMES = [[0.3] * len(JOINTS), [0.4] * len(JOINTS)]


def count_triangles():
    """Of the hand's visual meshes, which are OBJ files of triangles; a file counts as often as the URDF names it."""
    visuals = re.findall(r"<visual>.*?</visual>", URDF.read_text(), re.S)
    meshes = [HAND / name for visual in visuals for name in re.findall(r'filename="([^"]+)"', visual)]
    return sum(len(re.findall(r"^f ", mesh.read_text(), re.M)) for mesh in meshes)


def endless_scene():
    """A DAE whose scene doubles with every node, sixty times."""
    nodes = "".join(f'<node id="n{i}">' + 2 * f'<instance_node url="#n{i + 1}"/>' + "</node>" for i in range(60))
    return (f'<COLLADA version="1.4.1"><library_nodes>{nodes}<node id="n60"/></library_nodes><library_visual_scenes>'
            '<visual_scene id="s"><node id="root"><instance_node url="#n0"/></node></visual_scene></library_visual_scenes>'
            '<scene><instance_visual_scene url="#s"/></scene></COLLADA>')


def write_input():
    pathlib.Path("endless.dae").write_text(endless_scene())
    pathlib.Path("endless.urdf").write_text(re.sub(r'filename="[^"]+"', 'filename="endless.dae"', URDF.read_text()))
    pathlib.Path("hand.json").write_text('{"palm_link": "palm"}')
    pathlib.Path("actions.json").write_text(json.dumps({"format": "uhas-actions", "version": 1, "actions": [[0] * 15] * 3}))
    trajectory = {"format": "uhas-trajectory", "version": 1, "joint_names": JOINTS, "q": FRAMES}
    pathlib.Path("t.json").write_text(json.dumps(trajectory))
    with h5py.File("t.h5", "w") as file:
        file["q"] = FRAMES
        file["joint_names"] = np.array(JOINTS, "S16")


def cases():
    """(option, a bound that is too low, one that fits or None when none does, command)"""
    size = os.path.getsize
    explain, inspect = f"uhas-explain-hand {URDF} --config hand.json", f"uhas-inspect hand.h5 --gltf hand.glb --urdf {URDF}"
    solve, retarget = "uhas-solve actions.json --profile hand.h5", "uhas-retarget --from hand.h5 --to hand.h5 -o new.json"
    exact = [
        ("--max-config-bytes", size("hand.json"), explain),
        ("--max-urdf-bytes", size(URDF), explain),
        ("--max-links", URDF.read_text().count("<link "), explain),
        ("--max-mesh-bytes", max(size(mesh) for mesh in (HAND / "meshes").iterdir()), explain),
        ("--max-triangles", count_triangles(), explain),
        ("--max-urdf-bytes", size(URDF), inspect),
        ("--max-triangles", count_triangles(), inspect),
        ("--max-json-bytes", size("actions.json"), solve),
        ("--max-actions", 3, solve),
        ("--max-json-bytes", size("t.json"), retarget + " t.json"),
        ("--max-hdf5-bytes", 2 * 8 * len(JOINTS) + 16 * len(JOINTS), retarget + " t.h5"),
    ]
    return [(option, bound - 1, bound, command) for option, bound, command in exact] + [
        ("--max-read-bytes", 1, 1 << 30, explain),
        ("--max-read-bytes", 1, 1 << 30, solve),
        ("--max-read-bytes", 1, 1 << 30, retarget + " t.h5"),
        ("--max-read-seconds", 1, None, "uhas-explain-hand endless.urdf"),
    ]


def run(command, environment):
    return subprocess.run(command.split(), env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)


def faults_of(option, too_low, enough, command, environment):
    refused = run(f"{command} {option} {too_low}", environment)
    if refused.returncode != 1 or refused.stderr.count("\n") != 1 or f"raise the bound by {option}\n" not in refused.stderr:
        yield f"beyond the bound of {too_low}: exit code {refused.returncode}, {refused.stderr}"
    if enough is None:
        return
    accepted = run(f"{command} {option} {enough}", environment)
    if accepted.returncode != 0:
        yield f"with the bound at {enough}: exit code {accepted.returncode}, {accepted.stderr}"


def options_of_tools(bin_folder):
    """The --max options that any tool has."""
    found = set()
    for tool in sorted(bin_folder.glob("uhas-*")):
        described = json.loads(subprocess.run([tool, "--describe", "json"], capture_output=True, text=True, check=True).stdout)
        found |= {name for option in described["options"] for name in option["names"] if name.startswith("--max-")}
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    bin_folder = parser.parse_args().bin.resolve()
    environment = dict(os.environ, PATH=f"{bin_folder}{os.pathsep}{os.environ['PATH']}", LC_ALL="C")

    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write_input()
        assert run(f"uhas-build-profile --quiet {URDF} -o hand.h5", environment).returncode == 0
        tried = cases()
        for option, too_low, enough, command in tried:
            faults = list(faults_of(option, too_low, enough, command, environment))
            failed += bool(faults)
            print("\n  ".join([f"{'FAILED' if faults else 'ok':6}  {option} of {command.split()[0]}", *faults]))
        os.chdir(HERE)
    untried = sorted(options_of_tools(bin_folder) - {option for option, *_ in tried})
    print(f"{len(tried)} bounds, {failed} failed" + "".join(f"\n{option} is not tried" for option in untried))
    return 1 if failed or untried else 0


if __name__ == "__main__":
    sys.exit(main())
