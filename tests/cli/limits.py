#!/usr/bin/env python3
"""Every bound that --limit sets: a file beyond it is refused by one line that names the limit, the same file passes when the
limit is raised to fit. Every name that a tool knows is tried. Other names and numbers are refused.

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
    """(limit, a bound that is too low, one that fits or None when none does, command)"""
    size = os.path.getsize
    explain, inspect = f"uhas-explain-hand {URDF} --config hand.json", f"uhas-inspect hand.h5 --gltf hand.glb --urdf {URDF}"
    solve, retarget = "uhas-solve actions.json --profile hand.h5", "uhas-retarget --from hand.h5 --to hand.h5 -o new.json"
    exact = [
        ("config-bytes", size("hand.json"), explain),
        ("urdf-bytes", size(URDF), explain),
        ("links", URDF.read_text().count("<link "), explain),
        ("mesh-bytes", max(size(mesh) for mesh in (HAND / "meshes").iterdir()), explain),
        ("triangles", count_triangles(), explain),
        ("urdf-bytes", size(URDF), inspect),
        ("triangles", count_triangles(), inspect),
        ("json-bytes", size("actions.json"), solve),
        ("actions", 3, solve),
        ("json-bytes", size("t.json"), retarget + " t.json"),
        ("hdf5-bytes", 2 * 8 * len(JOINTS) + 16 * len(JOINTS), retarget + " t.h5"),
    ]
    return [(limit, bound - 1, bound, command) for limit, bound, command in exact] + [
        # where HDF5 itself survives the want of memory: elsewhere it calls the file damaged, or crashes the child
        ("read-memory", "1000K", "1G", explain),
        ("read-memory", "1000K", "1G", solve),
        ("read-memory", "100K", "1G", retarget + " t.h5"),
        ("read-seconds", 1, None, "uhas-explain-hand endless.urdf"),
    ]


def run(command, environment):
    return subprocess.run(command.split(), env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)


def faults_of(limit, too_low, enough, command, environment):
    refused = run(f"{command} --limit {limit}={too_low}", environment)
    remedy = f"raise the bound by --limit {limit}=N\n"
    if refused.returncode != 1 or refused.stderr.count("\n") != 1 or not refused.stderr.endswith(remedy):
        yield f"beyond the bound of {too_low}: exit code {refused.returncode}, {refused.stderr}"
    if enough is None:
        return
    accepted = run(f"{command} --limit {limit}={enough}", environment)
    if accepted.returncode != 0:
        yield f"with the bound at {enough}: exit code {accepted.returncode}, {accepted.stderr}"


def limits_of_tools(bin_folder):
    """The names that --limit takes, of all tools."""
    found = set()
    for tool in sorted(bin_folder.glob("uhas-*")):
        described = subprocess.run([tool, "--describe", "json"], capture_output=True, text=True, check=True).stdout
        found |= set(json.loads(described)["limits"])
    return found


def faults_of_usage(names, environment):
    """What is no NAME=N is wrong usage; an unknown name is answered by the names there are, one without a number by its range."""
    for wrong in ("mesh=1", "mesh-bytes-=1", "mesh", "=1"):
        refused = run(f"uhas-solve actions.json --limit={wrong}", environment)
        if refused.returncode != 2 or not all(name in refused.stderr for name in names):
            yield f"--limit={wrong}: exit code {refused.returncode}, {refused.stderr}"
    for number in ("", "0", "-1", "1.5", "1k", "1 K", "K", "0x10", "18446744073709551616", "17179869184G"):
        command = ["uhas-solve", "actions.json", "--limit", f"json-bytes={number}"]
        refused = subprocess.run(command, env=environment, capture_output=True, text=True)
        if refused.returncode != 2 or "N a whole number" not in refused.stderr:
            yield f"--limit json-bytes={number}: exit code {refused.returncode}, {refused.stderr}"
    refused = run("uhas-solve actions.json --limit links=10001", environment)
    if refused.returncode != 2 or "from 1 to 10000" not in refused.stderr:
        yield f"--limit links=10001: exit code {refused.returncode}, {refused.stderr}"


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
        for limit, too_low, enough, command in tried:
            faults = list(faults_of(limit, too_low, enough, command, environment))
            failed += bool(faults)
            print("\n  ".join([f"{'FAILED' if faults else 'ok':6}  {limit} of {command.split()[0]}", *faults]))
        names = limits_of_tools(bin_folder)
        usage = list(faults_of_usage(names, environment))
        failed += bool(usage)
        print("\n  ".join([f"{'FAILED' if usage else 'ok':6}  wrong usage", *usage]))
        os.chdir(HERE)
    untried = sorted(names - {limit for limit, *_ in tried})
    print(f"{len(tried)} bounds, {failed} failed" + "".join(f"\n{name} is not tried" for name in untried))
    return 1 if failed or untried else 0


if __name__ == "__main__":
    sys.exit(main())
