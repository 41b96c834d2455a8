#!/usr/bin/env python3
"""Runs every command of README.md and of the pages of docs/ that are for users.

    check_readme.py --bin build/dev/bin

Commands with their output, as in `$ uhas-solve …`, must print what the page shows, `...` standing for any lines; commands of the
tools within a sentence or a table must succeed. The long ones, which build everything, are run by tests/run.sh: that it does is
checked here. The programs of docs/library.md are built and run by the test `install`.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import check_man

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import transcript  # noqa: E402

HAND = ROOT / "hands/allegro_right"
PAGES = ["README.md", "docs/conventions.md", "docs/hand-read-wrongly.md", "docs/library.md", "docs/tools.md"]

# commands of the pages that build everything, and what tests/run.sh has in their place
RUN_BY_CI = {
    "examples/quickstart.sh": "examples/quickstart.sh",
    "tests/run.sh": "tests/run.sh",
    "cmake --preset release": "examples/quickstart.sh",
    "cmake --build --preset release": "examples/quickstart.sh",
    "cpack --preset release": "cpack --preset release",
    "cmake --preset runtime-only": "build runtime-only",
    "cmake --build --preset runtime-only": "build runtime-only",
    "cmake --install build/runtime-only --prefix DIR": "tests/install/check_install.py build/runtime-only",
}


def transcripts(text):
    """[(command, output shown)] of the indented lines that begin with `$` and of what follows them, up to the next."""
    return [(command, re.sub(r"^    ", "", shown, flags=re.M))
            for command, shown in re.findall(r"^    \$ (.*)\n((?:    (?!\$ ).*\n|\n(?=    (?!\$ )))*)", text, re.M)]


def inline_commands(text):
    """Commands in code spans; one that names nothing but options, as `uhas-solve --avoid`, only speaks of them."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    spans = [span for span in re.findall(r"`([^`\n]+)`", text) if re.match(r"uhas-\S+ .|man -l|cmake ", span)]
    return [span for span in spans if not re.fullmatch(r"uhas-\S+( --\S+)+", span)]


def script_commands(text):
    """Commands of the indented blocks without `$`."""
    lines = re.findall(r"^    ((?:examples|tests)/\S+)", text, re.M)
    return [line for line in lines if line.endswith(".sh")]


def prepare(folder, environment):
    """What the pages' names stand for."""
    shutil.copytree(HAND, folder, dirs_exist_ok=True)
    shutil.copy(HAND / "allegro_right.urdf", folder / "hand.urdf")
    shutil.copytree(ROOT / "examples", folder / "examples")
    shutil.copytree(ROOT / "man", folder / "man")
    actions = json.loads((ROOT / "examples/first_actions.json").read_text())
    (folder / "actions.json").write_text(json.dumps(actions | {"profile": "hand.h5"}))
    (folder / "trajectory.jsonl").write_text("".join(json.dumps(line) + "\n" for line in check_man.TRAJECTORY))
    subprocess.run(["uhas-build-profile", "--quiet", "hand.urdf", "-o", "hand.h5"], check=True, cwd=folder, env=environment)
    for name in ("a.h5", "b.h5"):
        shutil.copy(folder / "hand.h5", folder / name)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the tools")
    bin_folder = parser.parse_args().bin.resolve()

    environment = dict(os.environ, PATH=f"{bin_folder}:{os.environ['PATH']}", MANPAGER="cat")
    ci = (ROOT / "tests/run.sh").read_text()
    faults, count = [], 0
    for page in PAGES:
        text = (ROOT / page).read_text()
        commands = transcripts(text) + [(command, "") for span in inline_commands(text) for command in span.split(" && ")]
        commands += [(command, "") for command in script_commands(text)]
        count += len(commands)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            prepare(folder, environment)
            for command, shown in commands:
                if command not in RUN_BY_CI:
                    faults += [f"{page}: {fault}" for fault in transcript.run(command, shown, folder, environment)]
                elif RUN_BY_CI[command] not in ci:
                    faults.append(f"{page}: '{command}': tests/run.sh does not run it")
    if count < 20:
        faults.append(f"only {count} commands found in {', '.join(PAGES)}")
    print("\n".join(faults) if faults else f"{count} commands run")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
