#!/usr/bin/env python3
"""The man pages, the tools and the formats say the same.

    check_man.py --bin build/dev/bin

Every tool has a page and every page a tool. Every option of the tool's parser (--describe) is in --help and on the page, by the
same names, with the same argument and the same default; every option of both is one of the parser's. uhas(7) names every tool
and every limit with its default, uhas-hand-config(5) every key of the schema, uhas-hand-profile(5) every dataset of the list, and none that is not there. The
examples of every page run, leave stderr empty, and print what the page shows. mandoc finds no fault, where mandoc is installed.
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
sys.path.insert(0, str(ROOT / "tests/support"))
import mdoc  # noqa: E402
import transcript  # noqa: E402

SECTIONS = {
    "1": ["NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "FILES", "EXIT STATUS", "EXAMPLES", "SEE ALSO"],
    "5": ["NAME", "DESCRIPTION", "FILES", "EXAMPLES", "SEE ALSO"],
    "7": ["NAME", "DESCRIPTION", "FILES", "EXIT STATUS", "EXAMPLES", "SEE ALSO"],
}

# what the examples find in their folder, besides the hand of hands/allegro_right
HAND_CONFIG = '{"palm_link": "palm"}'
ACTIONS = '{"format": "uhas-actions", "version": 1, "actions": [[0,0,0,0.2,0, 0,0, 0,0, 0,0, -0.3,-0.3, 0,0]]}'
JOINTS = [f"{finger}_joint_{i}" for finger in ("index", "middle", "ring", "thumb") for i in range(4)]
TRAJECTORY = [{"format": "uhas-trajectory", "version": 1, "joint_names": JOINTS}, [0.4] * 16, [0.5] * 16]


def options_of_help(text):
    """{option names: argument} from the output of --help."""
    options = {}
    for entry in re.findall(r"^  -\S.*(?:\n {20,}\S.*)*", text, re.M):
        flags, _ = re.split(r"\s{2,}|\n\s*", entry.strip(), maxsplit=1)
        names, _, argument = flags.removesuffix(" REQUIRED").partition(" ")
        options[frozenset(names.split(","))] = argument
    return options


def options_of_parser(command_line):
    """{option names: (argument, default or None)}; a description ends in its default, in brackets, when that is one word."""
    options = {}
    for option in command_line["options"]:
        default = re.search(r"\[([\w.]+)\]$", option["text"])
        options[frozenset(option["names"])] = (option["argument"], default and default[1])
    return options


def named(names):
    return ", ".join(sorted(names))


def difference(one, one_name, other, other_name):
    """Messages on what only one of two sets has."""
    faults = [f"{item} of {one_name} is not in {other_name}" for item in sorted(one - other)]
    return faults + [f"{item} of {other_name} is not in {one_name}" for item in sorted(other - one)]


def compare_options(command_line, help_text, sections):
    """Faults of a page and of --help against the parser of their tool."""
    parsed, in_help = options_of_parser(command_line), options_of_help(help_text)
    on_page = mdoc.options_of(sections["OPTIONS"])
    faults = difference(set(map(named, parsed)), "the parser", set(map(named, in_help)), "--help")
    faults += difference(set(map(named, parsed)), "the parser", set(map(named, on_page)), "the page")
    for names in parsed.keys() & in_help.keys() & on_page.keys():
        (argument, default), (page_argument, text) = parsed[names], on_page[names]
        if not argument == in_help[names] == page_argument:
            faults.append(f"{named(names)} takes '{argument}', '{in_help[names]}' in --help, '{page_argument}' on the page")
        if default and not re.search(rf"(?<!\w){re.escape(default)}(?!\w)", text):
            faults.append(f"{named(names)}: its default {default} is not on the page")
        if not any(re.search(rf"Fl {re.escape(name[1:])}(?!\S)", sections["SYNOPSIS"]) for name in names):
            faults.append(f"{named(names)} is not in SYNOPSIS")
    for positional in command_line["positionals"]:
        if f".Ar {positional['names'][0]}" not in sections["SYNOPSIS"]:
            faults.append(f"argument {positional['names'][0]} is not in SYNOPSIS")
    return faults


def check_tools(pages, bin_folder):
    """Faults of the pages of section 1."""
    of_tools = {path.stem: path for path in pages if path.suffix == ".1"}
    tools = {path.name: path for path in sorted(bin_folder.glob("uhas-*")) if os.access(path, os.X_OK)}
    yield from difference(tools.keys(), "the tools", of_tools.keys(), "man/*.1")
    for tool in sorted(tools.keys() & of_tools.keys()):
        help_text, description = (subprocess.run([tools[tool], *arguments], capture_output=True, text=True, check=True).stdout
                                  for arguments in (["--help"], ["--describe", "json"]))
        sections = mdoc.sections_of(of_tools[tool].read_text())
        if all(title in sections for title in SECTIONS["1"]):
            yield from (f"{tool}: {fault}" for fault in compare_options(json.loads(description), help_text, sections))


def check_overviews(pages):
    """Faults of the pages of sections 5 and 7 against what they are about."""
    text = {path.name: path.read_text() for path in pages}
    tools = {f"{path.stem}(1)" for path in pages if path.suffix == ".1"}
    referred = {reference for reference in mdoc.references(text["uhas.7"]) if reference.endswith("(1)")}
    yield from difference(tools, "man/*.1", referred, "uhas(7)")

    schema = json.loads((ROOT / "schemas/hand-config.schema.json").read_text())
    keys = set(re.findall(r"^\.It Cm (\S+)", text["uhas-hand-config.5"], re.M))
    fingertip = schema["properties"]["fingertips"]["items"]["properties"]
    yield from difference(set(schema["properties"]) | set(fingertip), "the schema", keys, "uhas-hand-config(5)")

    listed = json.loads((ROOT / "schemas/hand-profile-v1.datasets.json").read_text())["datasets"]
    datasets = set(re.findall(r"^\.It Pa /(\S+)", text["uhas-hand-profile.5"], re.M))
    yield from difference({entry["path"] for entry in listed}, "the list", datasets, "uhas-hand-profile(5)")


def check_limits(pages, bin_folder):
    """Faults of the table of limits of uhas(7), whose rows are `Cm name Ta default Ta ...`, against the tools."""
    text = next(page for page in pages if page.name == "uhas.7").read_text()
    table = {f"{name} [{default}]" for name, default in re.findall(r"^\.It Cm (\S+) Ta (\d+) Ta", text, re.M)}
    limits = set()
    for tool in bin_folder.glob("uhas-*"):
        described = subprocess.run([tool, "--describe", "json"], capture_output=True, text=True, check=True).stdout
        limits |= {f"{name} [{default}]" for name, default in json.loads(described)["limits"].items()}
    return difference(limits, "the tools", table, "the table of uhas(7)")


def check_sections(page):
    sections = mdoc.sections_of(page.read_text())
    missing = [title for title in SECTIONS[page.suffix[1:]] if title not in sections]
    codes = re.findall(r"^\.It (\d)$", sections.get("EXIT STATUS", ""), re.M)
    if "EXIT STATUS" in sections and codes != ["0", "1", "2"]:
        missing.append("the exit codes 0, 1, 2")
    return [f"{page.name} lacks {', '.join(missing)}"] if missing else []


def run_examples(page, environment):
    """Faults of the commands of EXAMPLES, run one after another."""
    commands = mdoc.transcripts(mdoc.sections_of(page.read_text()).get("EXAMPLES", ""))
    faults = [] if commands else ["no example"]
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(ROOT / "hands/allegro_right", folder, dirs_exist_ok=True)
        shutil.copytree(ROOT / "hands/leap_right", pathlib.Path(folder, "leap"))
        os.rename(f"{folder}/allegro_right.urdf", f"{folder}/hand.urdf")
        pathlib.Path(folder, "hand.json").write_text(HAND_CONFIG)
        pathlib.Path(folder, "actions.json").write_text(ACTIONS)
        pathlib.Path(folder, "trajectory.jsonl").write_text("".join(json.dumps(line) + "\n" for line in TRAJECTORY))
        for command, shown in commands:
            faults += transcript.run(command, shown, folder, environment)
    return [f"{page.name}: {fault}" for fault in faults]


def lint(pages):
    if not shutil.which("mandoc"):
        print("SKIPPED: the lint of the pages: mandoc is not installed")
        return []
    return subprocess.run(["mandoc", "-T", "lint", "-W", "warning", *pages], capture_output=True, text=True).stdout.splitlines()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the tools")
    bin_folder = parser.parse_args().bin.resolve()

    pages = sorted((ROOT / "man").iterdir())
    # the Python that has h5py, as the examples call it
    environment = dict(os.environ, PATH=f"{bin_folder}:{pathlib.Path(sys.executable).parent}:{os.environ['PATH']}")
    faults = [*check_tools(pages, bin_folder), *check_overviews(pages), *check_limits(pages, bin_folder), *lint(pages)]
    for page in pages:
        faults += check_sections(page) + run_examples(page, environment)
    print("\n".join(faults) if faults else f"{len(pages)} pages agree with tools and formats")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
