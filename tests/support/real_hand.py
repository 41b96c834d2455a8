"""The real hand a script runs on: UHAS_HANDS_DIR holds one folder a hand."""

import json
import os
import pathlib
import sys

SKIPPED = 77  # ctest's SKIP_RETURN_CODE of these tests


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(SKIPPED)


def find_hand(name):
    """(folder, URDF). Skips when UHAS_HANDS_DIR is not set, fails when it is set but wrong."""
    if "UHAS_HANDS_DIR" not in os.environ:
        skip("UHAS_HANDS_DIR is not set")
    folder = pathlib.Path(os.environ["UHAS_HANDS_DIR"]) / name
    try:
        truth = json.loads((folder / "truth.json").read_text())
    except OSError as error:
        sys.exit(f"UHAS_HANDS_DIR is set, but {error}")
    return folder, folder / truth["urdf"]
