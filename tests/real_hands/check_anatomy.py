#!/usr/bin/env python3
"""Runs the comparison script that comes with the real hands, UHAS_HANDS_DIR/../tools/check_anatomy.py, on what
uhas-inspect and uhas-classify-joints say of a hand."""

import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import real_hand  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    parser.add_argument("--hand", required=True, help="folder in UHAS_HANDS_DIR")
    arguments = parser.parse_args()
    hand, urdf = real_hand.find_hand(arguments.hand)
    script = hand.parent.parent / "tools" / "check_anatomy.py"
    if not script.exists():
        real_hand.skip(f"no comparison script at {script}")

    failed = False
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def compare(tool, subject, *switches):
            document = folder / "summary.json"
            with document.open("w") as file:
                subprocess.run([arguments.bin / tool, subject, "--json"], check=True, stdout=file)
            done = subprocess.run([sys.executable, script, hand / "truth.json", document, *switches])
            return done.returncode != 0

        profile = folder / "hand.h5"
        subprocess.run([arguments.bin / "uhas-build-profile", "--quiet", urdf, "-o", profile], check=True)
        failed |= compare("uhas-inspect", profile)
        failed |= compare("uhas-classify-joints", urdf, "--classes-only")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
