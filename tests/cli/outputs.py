#!/usr/bin/env python3
"""No file is lost: every output of every tool, written over what it must not replace.

    outputs.py --bin build/dev/bin

An output that is one of the inputs, by whatever name, is refused, with --force too; so is a file of another kind, or a read-only
one, without --force. After each refusal every file is as it was, and there is no other.
"""
import argparse
import hashlib
import json
import os
import pathlib
import shutil
import stat
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
URDF, MESH = "hand/allegro_right.urdf", "hand/meshes/finger_base.obj"
MODEL = ["--urdf", URDF]
JOINTS = [f"{finger}_joint_{i}" for finger in ("index", "middle", "ring", "thumb") for i in range(4)]
INPUTS = {
    "config.json": '{"palm_link": "palm"}',
    "actions.json": '{"format": "uhas-actions", "version": 1, "profile": "hand.h5", "actions": [' + str([0] * 15) + "]}",
    "t.jsonl": f'{json.dumps({"format": "uhas-trajectory", "version": 1, "joint_names": JOINTS})}\n{[0.4] * 16}\n',
}
EVALUATE = ["uhas-evaluate", "hand.h5", "--actions", "5", "--lines", "0", *MODEL]
BUILD = ["uhas-build-profile", URDF, "--config", "config.json", "--samples", "2000"]

# (command without its output, option, what it reads)
CASES = [
    (BUILD, "-o", [URDF, MESH, "config.json"]),
    (BUILD + ["-o", "free.h5"], "--write-config", [URDF, MESH, "config.json"]),
    (["uhas-explain-hand", URDF, "--config", "config.json"], "--write-config", [URDF, MESH, "config.json"]),
    (["uhas-project-surface", URDF, "--samples", "2000"], "-o", [URDF, MESH]),
    (["uhas-solve", "actions.json"], "-o", ["actions.json", "hand.h5"]),
    (["uhas-solve", "actions.json", *MODEL], "--html", ["actions.json", "hand.h5", URDF, MESH]),
    (["uhas-retarget", "t.jsonl", "--from", "hand.h5", "--to", "hand.h5"], "-o", ["t.jsonl"]),
    (EVALUATE, "--html", ["hand.h5", URDF, MESH]),
    *((["uhas-inspect", "hand.h5", *(MODEL if option in ("--html", "--gltf") else [])], option, ["hand.h5"])
      for option in ("--html", "--gltf", "--ply", "--svg")),
    (["uhas-inspect", "hand.h5", "--gltf", "free.glb", *MODEL], "--html", [URDF, MESH]),
]


def run(command):
    return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120)


def listing():
    """Every file below the current folder: mode and content."""
    return {str(path): (path.lstat().st_mode, hashlib.sha256(path.read_bytes()).hexdigest())
            for path in sorted(pathlib.Path().rglob("*")) if path.is_file()}


def fresh_folder(scratch, number, profile):
    """A folder that holds every input, as the current one."""
    folder = scratch / str(number)
    folder.mkdir()
    os.chdir(folder)
    shutil.copytree(ROOT / "hands/allegro_right", "hand")
    shutil.copy(profile, "hand.h5")
    for name, text in INPUTS.items():
        pathlib.Path(name).write_text(text)


def names_of(path):
    """Other names of a file, each with the same ending."""
    suffix = pathlib.Path(path).suffix
    os.symlink(path, "symbolic" + suffix)
    os.link(path, "hard" + suffix)
    return [path, f"./hand/../{path}", "symbolic" + suffix, "hard" + suffix]


def refusals(command, option, inputs):
    """Faults of a command that is to write over what it reads."""
    for path in inputs:
        for name in names_of(path):
            before = listing()
            for force in ([], ["--force"]):
                done = run([*command, option, name, *force])
                # that a mesh is read shows after the URDF has been read, that a file is of another kind before
                reasons = ["would be written, but it is read too", *([] if force else ["exists and is no "])]
                told = any(f"error: {name}: {reason}" in done.stderr for reason in reasons)
                if done.returncode != 1 or not told or "; write to another file" not in done.stderr:
                    yield f"{option} {name} {force}: {done.returncode} {done.stderr}"
            if listing() != before:
                yield f"{option} {name}: files have changed"
        for link in pathlib.Path().glob("symbolic.*"):
            link.unlink()
        for link in pathlib.Path().glob("hard.*"):
            link.unlink()


def replacements(command, option):
    """Faults of a command that is to write over other files."""
    output = pathlib.Path({"-o": "out.jsonl"}.get(option, "out.x"))
    output.write_text("my notes\n")
    done = run([*command, option, output])
    if done.returncode != 1 or f"{output}: exists and is no " not in done.stderr or output.read_text() != "my notes\n":
        yield f"{option} over another kind: {done.returncode} {done.stderr}"
    for what, arguments in (("--force over another kind", ["--force"]), ("over its own kind", [])):
        done = run([*command, option, output, *arguments])
        if done.returncode != 0 or output.read_bytes().startswith(b"my notes"):
            yield f"{option} {what}: {done.returncode} {done.stderr}"
    output.chmod(0o444)
    done = run([*command, option, output])
    if done.returncode != 1 or f"{output}: is read-only; " not in done.stderr:
        yield f"{option} over a read-only file: {done.returncode} {done.stderr}"
    if (code := run([*command, option, output, "--force"]).returncode) != 0:
        yield f"{option} --force over a read-only file: {code}"
    output.unlink()
    output.touch()
    if (code := run([*command, option, output]).returncode) != 0:
        yield f"{option} over an empty file: {code}"


def others():
    """Faults of what is no option of one output."""
    pathlib.Path("allegro_right.h5").write_text("my notes\n")
    done = run(["uhas-build-profile", URDF, "--samples", "2000"])
    if done.returncode != 1 or pathlib.Path("allegro_right.h5").read_text() != "my notes\n":
        yield f"the default output over another kind: {done.stderr}"
    done = run(["uhas-inspect", "hand.h5", "--ply", "one", "--svg", "./one"])
    if done.returncode != 1 or "two results would be written to it" not in done.stderr or os.path.exists("one"):
        yield f"two results to one file: {done.stderr}"
    os.chmod("hand.h5", stat.S_IRUSR)
    done = run(["uhas-inspect", "hand.h5", "--reseal"])
    if done.returncode != 1 or "hand.h5: is read-only" not in done.stderr:
        yield f"a read-only profile resealed: {done.stderr}"
    if (code := run(["uhas-inspect", "hand.h5", "--reseal", "--force"]).returncode) != 0:
        yield f"a read-only profile resealed with --force: {code}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    options = parser.parse_args()
    os.environ.update(PATH=f"{options.bin.resolve()}{os.pathsep}{os.environ['PATH']}", LC_ALL="C")

    failed = 0
    with tempfile.TemporaryDirectory() as name:
        scratch, profile = pathlib.Path(name), pathlib.Path(name) / "hand.h5"
        subprocess.run(["uhas-build-profile", "--quiet", ROOT / "hands" / "allegro_right/allegro_right.urdf", "-o", profile],
                       check=True)
        for number, (command, option, inputs) in enumerate(CASES):
            fresh_folder(scratch, number, profile)
            faults = [*refusals(command, option, inputs), *replacements(command, option)]
            print(f"{'FAILED' if faults else 'ok':6}  {command[0]} {option}", *faults, sep="\n  ")
            failed += bool(faults)
        fresh_folder(scratch, "others", profile)
        faults = list(others())
        print(f"{'FAILED' if faults else 'ok':6}  others", *faults, sep="\n  ")
        failed += bool(faults)
    print(f"{len(CASES) + 1} cases, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
