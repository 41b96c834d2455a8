#!/usr/bin/env python3
"""The same input gives the same bytes: profiles, JSON, pictures and solutions of every hand in hands/, and of those in
UHAS_HANDS_DIR, from every build that is named; and from the first of them once more elsewhere: on one processor and one thread
instead of three, in another locale, time zone, home and folder, with the hand copied to a path with a space.

    same_bytes.py --bin build/dev/bin --bin build/release/bin [--hand NAME]...

Scores are compared without the time of a solve, which is measured.
"""
import argparse
import concurrent.futures
import dataclasses
import hashlib
import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
OWN_HANDS = HERE.parent.parent / "hands"
LOCALE = "de_DE.UTF-8"  # of a decimal comma
SOLVES = ["", "--rule contact", "--closing hard", "--field field", "--passes 3", "--convention uhas-sim", "--collisions --avoid --urdf {urdf}"]


@dataclasses.dataclass
class Place:
    """Where and how the tools run."""
    name: str
    bin: pathlib.Path
    threads: int = 3
    elsewhere: bool = False
    environment: dict = dataclasses.field(default_factory=lambda: dict(os.environ, LC_ALL="C"))


@dataclasses.dataclass
class Hand:
    name: str
    folder: pathlib.Path  # with all that belongs to it
    urdf: pathlib.Path    # relative to the folder


def hands(names):
    """Those of that name, or all."""
    found = [Hand(urdf.stem, urdf.parent, pathlib.Path(urdf.name)) for urdf in sorted(OWN_HANDS.glob("*/*.urdf"))]
    for truth in sorted(pathlib.Path(os.environ.get("UHAS_HANDS_DIR", "/nowhere")).glob("*/truth.json")):
        found.append(Hand(truth.parent.name, truth.parent.resolve(), pathlib.Path(json.loads(truth.read_text())["urdf"])))
    return [hand for hand in found if not names or hand.name in names]


def compile_locale(folder):
    """False, and a word on it, where the system has no sources of locales."""
    made = subprocess.run(["localedef", "-i", LOCALE.split(".")[0], "-f", "UTF-8", folder / LOCALE], capture_output=True)
    if made.returncode != 0:
        print(f"SKIPPED: the locale {LOCALE}: {made.stderr.decode().strip()}")
    return made.returncode == 0


def write_actions(folder):
    draw = random.Random(3)
    actions = [[0.0] * 15] + [[draw.uniform(-0.5, 0.5) for _ in range(5)] + [draw.uniform(-2, 2) for _ in range(10)] for _ in range(30)]
    document = {"format": "uhas-actions", "version": 1, "profile": "hand.h5", "actions": actions}
    (folder / "actions.json").write_text(json.dumps(document))
    (folder / "actions.jsonl").write_text("".join(json.dumps(action) + "\n" for action in actions))


def write_trajectory(folder):
    solution = json.loads((folder / "solve.json").read_text())
    document = {"format": "uhas-trajectory", "version": 1, "joint_names": solution["joint_names"],
                "q": [frame["q"] for frame in solution["solutions"]]}
    (folder / "trajectory.json").write_text(json.dumps(document))


def without_times(scores):
    document = json.loads(scores)
    for hand in document["hands"]:
        del hand["time"]
    return json.dumps(document).encode()


def make_everything(place, urdf, folder):
    """Fills the folder with all that the tools make of the hand. Each command's standard output is a file there, too."""
    def run(output, program, arguments="", change=bytes, environment={}, **options):
        command = [program if os.path.sep in str(program) else place.bin / program]
        command += [word.format(urdf=urdf) for word in arguments.split()]
        if place.elsewhere:
            command = ["taskset", "-c", "0", *command]
        done = subprocess.run(command, cwd=folder, env=place.environment | environment, capture_output=True, **options)
        if done.returncode != 0:
            sys.exit(f"{place.name}: {' '.join(map(str, command))}: {done.stderr.decode()}")
        (folder / output).write_bytes(change(done.stdout))

    run("build.json", "uhas-build-profile", "{urdf} -o hand.h5 --write-config config.json --json")
    run("explanation.json", "uhas-explain-hand", "{urdf} --json")
    run("sphere.json", "uhas-sphere-frame", "{urdf} --json")
    run("classes.json", "uhas-classify-joints", "{urdf} --json")
    run("tables.json", "uhas-lateral-tables", "{urdf} --json")
    run("surface.json", "uhas-project-surface", "{urdf} -o points.json --json")
    run("summary.json", "uhas-inspect", "hand.h5 --json --findings")
    run("summary.txt", "uhas-inspect", "hand.h5 --html hand.html --gltf hand.glb --ply points.ply --svg tables.svg --urdf {urdf}")
    write_actions(folder)
    for options in SOLVES:
        run(f"solve{options.split('--urdf')[0].strip().replace(' ', '_')}.json", "uhas-solve", f"actions.json {options}")
    run("stream.jsonl", "uhas-solve", "- --profile hand.h5", input=(folder / "actions.jsonl").read_bytes())
    run("page.txt", "uhas-solve", "actions.json --html solution.html --urdf {urdf}")
    write_trajectory(folder)
    for output in ("retargeted.jsonl", "retargeted.h5"):
        run(f"{output}.txt", "uhas-retarget", f"--from hand.h5 --to hand.h5 trajectory.json --driving-vectors 3 -o {output} --json")
    run("scores.json", "uhas-evaluate", f"hand.h5 --actions 10 --lines 4 --threads {place.threads} --urdf {{urdf}} --json",
        change=without_times)
    for instructions in ("scalar", "baseline", "avx2"):
        run(f"batch_{instructions}.q", sys.executable,
            f"{HERE / 'solve_batch.py'} {place.bin.parent / 'lib' / 'libuhas.so'} hand.h5 {place.threads}",
            environment={"UHAS_INSTRUCTION_SET": instructions})


def digests(place, hand, scratch):
    """{file: SHA-256} of all that is made of the hand there."""
    folder = pathlib.Path(tempfile.mkdtemp(dir=scratch))
    urdf = hand.folder / hand.urdf
    if place.elsewhere:
        shutil.copytree(hand.folder, folder / "a hand" / "copied")
        urdf = pathlib.Path("..", "a hand", "copied", hand.urdf)
    work = folder / "work"
    work.mkdir()
    make_everything(place, urdf, work)
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in work.iterdir()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, action="append", help="folder of built tools; repeatable")
    parser.add_argument("--hand", action="append", help="only these hands; repeatable")
    options = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        places = [Place(str(bin_dir), bin_dir.resolve()) for bin_dir in options.bin]
        away = Place("elsewhere", places[0].bin, threads=1, elsewhere=True)
        away.environment |= {"TZ": "Pacific/Auckland", "HOME": scratch}
        if compile_locale(pathlib.Path(scratch)):
            away.environment |= {"LOCPATH": scratch, "LC_ALL": LOCALE, "LANG": LOCALE}
        places += [away]
        for hand in hands(options.hand):
            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
                expected, *others = workers.map(lambda place: digests(place, hand, scratch), places)
            for place, found in zip(places[1:], others):
                differ = sorted(file for file in expected | found if expected.get(file) != found.get(file))
                failed += bool(differ)
                print(f"{'FAILED' if differ else 'ok':6}  {hand.folder}: {len(expected)} files of {places[0].name} and of {place.name}",
                      *[f"differ: {file}" for file in differ], sep="\n        ", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
