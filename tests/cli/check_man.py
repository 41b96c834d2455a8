#!/usr/bin/env python3
"""The man pages and the tools say the same.

    check_man.py --bin build/dev/bin

Every tool has a page and every page a tool. Every option of --help is on the page, by the same names, with the same
argument and the same default; every option on the page is in --help. The examples of every page run. mandoc finds no
fault, where mandoc is installed.
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

ROOT = pathlib.Path(__file__).resolve().parents[2]
SECTIONS = ["NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "EXAMPLES", "SEE ALSO"]

# what the examples find in their folder, besides the hand of hands/allegro_right
HAND_CONFIG = '{"palm_link": "palm"}'
ACTIONS = '{"format": "uhas-actions", "version": 1, "actions": [[0,0,0,0.2,0, 0,0, 0,0, 0,0, -0.3,-0.3, 0,0]]}'
JOINTS = [f"{finger}_joint_{i}" for finger in ("index", "middle", "ring", "thumb") for i in range(4)]
TRAJECTORY = [{"format": "uhas-trajectory", "version": 1, "joint_names": JOINTS}, [0.4] * 16, [0.5] * 16]


def options_of_help(text):
    """{option names: (argument, default or None)} from the output of --help."""
    options = {}
    for entry in re.findall(r"^  -\S.*(?:\n {20,}\S.*)*", text, re.M):
        flags, description = re.split(r"\s{2,}|\n\s*", entry.strip(), maxsplit=1)
        names, _, argument = flags.removesuffix(" REQUIRED").partition(" ")
        default = re.search(r"\[([\w.]+)\]$", description)
        options[frozenset(names.split(","))] = (argument, default and default[1])
    return options


def sections_of(page):
    """{title: text} of an mdoc page."""
    parts = re.split(r"^\.Sh (.*)\n", page, flags=re.M)
    return {title: text for title, text in zip(parts[1::2], parts[2::2])}


def options_of_page(section):
    """{option names: (argument, text)} from the tagged list of OPTIONS."""
    options = {}
    for item in re.split(r"^\.It ", section, flags=re.M)[1:]:
        tag, _, text = item.partition("\n")
        names, argument = [], []
        words = iter(tag.split())
        for word in words:
            if word == "Fl":
                names.append("-" + next(words))
            elif word not in ("Ar", "Cm", "Ns") and not (word == "," and not argument):
                argument.append(word)
        options[frozenset(names)] = ("".join(argument), text)
    return options


def named(names):
    return ", ".join(sorted(names))


def compare_options(tool, help_text, sections):
    """Faults of one page against the help of its tool."""
    in_help, on_page = options_of_help(help_text), options_of_page(sections["OPTIONS"])
    assert in_help, f"{tool}: no options found in --help"
    faults = [f"{named(names)} of --help is not on the page" for names in in_help.keys() - on_page.keys()]
    faults += [f"{named(names)} of the page is not in --help" for names in on_page.keys() - in_help.keys()]
    for names in in_help.keys() & on_page.keys():
        (argument, default), (page_argument, text) = in_help[names], on_page[names]
        if argument != page_argument:
            faults.append(f"{named(names)} takes '{argument}' in --help, '{page_argument}' on the page")
        if default and not re.search(rf"(?<!\w){re.escape(default)}(?!\w)", text):
            faults.append(f"{named(names)}: its default {default} is not on the page")
        long_name = max(names, key=len)
        if f"Fl {long_name[1:]}" not in sections["SYNOPSIS"] and f"Fl {min(names, key=len)[1:]}" not in sections["SYNOPSIS"]:
            faults.append(f"{long_name} is not in SYNOPSIS")
    usage = re.search(r"^Usage: \S+ \[OPTIONS\] (.+)$", help_text, re.M)
    if usage and f".Ar {usage[1]}" not in sections["SYNOPSIS"]:
        faults.append(f"argument {usage[1]} is not in SYNOPSIS")
    return faults


def run_examples(section, folder, environment):
    """Faults of the commands of EXAMPLES, run one after another."""
    commands = re.findall(r"^\.Dl \$ (.*)$", section, re.M)
    faults = [] if commands else ["no example"]
    for command in commands:
        result = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, capture_output=True, text=True)
        if result.returncode != 0 or result.stderr:
            faults.append(f"example '{command}' exits with {result.returncode}: {result.stderr.strip()}")
    return faults


def main():
    parser = argparse.ArgumentParser(description="Check the man pages against the tools.")
    parser.add_argument("--bin", required=True, help="folder of the tools")
    bin_folder = pathlib.Path(parser.parse_args().bin).resolve()

    pages = {path.stem: path for path in sorted((ROOT / "man").glob("*.1"))}
    tools = {path.name: path for path in sorted(bin_folder.glob("uhas-*")) if os.access(path, os.X_OK)}
    faults = [f"{tool}: has no page in man/" for tool in tools.keys() - pages.keys()]
    faults += [f"{page}: has no tool in {bin_folder}" for page in pages.keys() - tools.keys()]

    environment = dict(os.environ, PATH=f"{bin_folder}:{os.environ['PATH']}")
    for tool in sorted(tools.keys() & pages.keys()):
        page = pages[tool].read_text()
        sections = sections_of(page)
        missing = [title for title in SECTIONS if title not in sections]
        if missing:
            faults.append(f"{tool}: the page lacks {', '.join(missing)}")
            continue
        help_text = subprocess.run([tools[tool], "--help"], capture_output=True, text=True, check=True).stdout
        found = compare_options(tool, help_text, sections)
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(ROOT / "hands/allegro_right", folder, dirs_exist_ok=True)
            os.rename(f"{folder}/allegro_right.urdf", f"{folder}/hand.urdf")
            pathlib.Path(folder, "hand.json").write_text(HAND_CONFIG)
            pathlib.Path(folder, "actions.json").write_text(ACTIONS)
            pathlib.Path(folder, "trajectory.jsonl").write_text("".join(json.dumps(line) + "\n" for line in TRAJECTORY))
            found += run_examples(sections["EXAMPLES"], folder, environment)
        faults += [f"{tool}: {fault}" for fault in found]

    if shutil.which("mandoc"):
        lint = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", *pages.values()], capture_output=True, text=True)
        faults += lint.stdout.splitlines()
    else:
        print("SKIPPED: the lint of the pages: mandoc is not installed")

    print("\n".join(faults) if faults else f"{len(pages)} pages agree with their tools")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
