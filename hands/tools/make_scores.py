#!/usr/bin/env python3
"""Writes hands/SCORES.md: the scores of the hands in hands/ and of those in UHAS_HANDS_DIR.

    make_scores.py --bin build/release/bin
"""

import argparse
import json
import os
import pathlib
import subprocess
import tempfile

HANDS = pathlib.Path(__file__).resolve().parent.parent
STEEP = 12  # rad a radius

HEAD = """# Scores

How good the profiles of all hands are that were at hand: those in this folder, and with a star those of other makers, which are not
part of the repository. `uhas-evaluate` measures them, 400 actions a hand; its man page says what each score is. Made by

    UHAS_HANDS_DIR=/path/to/hands hands/tools/make_scores.py --bin build/release/bin

The times are of one machine, with other work on it; [docs/performance.md](../docs/performance.md) has better ones.

"""

STEPS = """
## Steep joint steps

Joints that go further than {} rad for a radius of displacement somewhere, by the number of passes.
{}
Several passes go on to the least-squares optimum, and that itself is steep, or jumps, where a target passes behind a joint: the angle
of least squares turns by half a circle there, or goes over to the other limit. A jump's rate is what it is over a step of 0.01
halved 16 times.
"""


def urdf_of(folder):
    truth = folder / "truth.json"
    return folder / (json.loads(truth.read_text())["urdf"] if truth.exists() else f"{folder.name}.urdf")


def hands():
    """(label, URDF) of every hand."""
    for folder in sorted(path.parent for path in HANDS.glob("*/*.urdf")):
        yield folder.name, urdf_of(folder)
    if "UHAS_HANDS_DIR" in os.environ:
        for truth in sorted(pathlib.Path(os.environ["UHAS_HANDS_DIR"]).glob("*/truth.json")):
            yield truth.parent.name + " *", urdf_of(truth.parent)


def steep_steps(document, labels):
    """Markdown of the joints that are too steep, with the finger's inputs where they are."""
    lines = []
    for label, hand in zip(labels, document["hands"]):
        for solve in hand["smoothness"]:
            for step in solve["delta_r"]:
                if step["finest_rate"] <= STEEP:
                    continue
                at = ", ".join(f"{x:.3f}" for x in step["action"])
                rate = f"jump of {step['jump']:.2f} rad" if step["jump"] else f"{step['finest_rate']:.0f}"
                lines.append(f"| {label} | {solve['passes']} | {step['joint']} | {rate} | {at} |")
    head = "\n| hand | passes | joint | rad a radius | action |\n|---|---:|---|---:|---|\n"
    worst = "With one pass, the default, there are none." if not any("| 1 |" in line for line in lines) else ""
    return STEPS.format(STEEP, worst + "\n" + head + "\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    options = parser.parse_args()
    labels, urdfs = zip(*hands())
    with tempfile.TemporaryDirectory() as folder:
        profiles = []
        for label, urdf in zip(labels, urdfs):
            profiles.append(f"{folder}/{len(profiles)}.h5")
            subprocess.run([options.bin / "uhas-build-profile", urdf, "-o", profiles[-1], "--quiet"], check=True, stdout=subprocess.DEVNULL)
        command = [options.bin / "uhas-evaluate", *profiles, *(word for urdf in urdfs for word in ("--urdf", urdf))]
        table = subprocess.run([*command, "--markdown"], check=True, capture_output=True, text=True).stdout.splitlines()
        document = json.loads(subprocess.run([*command, "--json"], check=True, capture_output=True, text=True).stdout)
    table[0] = "| score | " + " | ".join(labels) + " |"
    (HANDS / "SCORES.md").write_text(HEAD + "\n".join(table) + "\n" + steep_steps(document, labels))


if __name__ == "__main__":
    main()
