#!/usr/bin/env python3
"""Writes the hands of this folder's parent: for each its URDF and the meshes of its links.

    make_hands.py [HAND...]            write the files of these hands; of all when none is named
    make_hands.py [HAND...] --check    write nothing; exit 1 when a file in the folder is not what would be written

The kinematic numbers are facts about the hands; the shapes are modelled here. See hands/README.md.
"""

import argparse
import pathlib
import sys

import allegro
import human
import leap
import shadow

HANDS = {"allegro_right": lambda: allegro.hand("right"), "allegro_left": lambda: allegro.hand("left"),
         "leap_right": leap.hand, "shadow_right": shadow.hand, "human_right": human.hand}
FOLDER = pathlib.Path(__file__).resolve().parent.parent


def differing_files(folder, files):
    """The files that are missing from the folder, are not as in `files`, or do not belong there."""
    present = {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    wanted = {name: text.encode() for name, text in files.items()}
    return sorted(name for name in present | wanted if present.get(name) != wanted.get(name))


def write(folder, files):
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())


def main():
    parser = argparse.ArgumentParser(description="Write the hands, or check what is there.")
    parser.add_argument("hands", nargs="*", metavar="HAND", help=f"one of {', '.join(HANDS)}; default all")
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 when a file differs")
    options = parser.parse_args()
    unknown = [name for name in options.hands if name not in HANDS]
    if unknown:
        parser.error(f"no hand named {unknown[0]}; there are {', '.join(HANDS)}")

    good = True
    for name in options.hands or HANDS:
        folder, files = FOLDER / name, HANDS[name]().files()
        if not options.check:
            write(folder, files)
        elif differing := differing_files(folder, files):
            good = False
            print(f"{folder}: not as written by {sys.argv[0]}: {', '.join(differing)}; run it without --check", file=sys.stderr)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
