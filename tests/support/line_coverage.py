#!/usr/bin/env python3
"""Prints the line coverage of lib/uhas by room, from a tracefile of lcov, and writes the lines that were not run to a file.

    line_coverage.py lib.info --not-run FILE --must PERCENT     exit 1 when less than PERCENT of all lines were run
"""
import argparse
import collections
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIBRARY = ROOT / "lib" / "uhas"


def counts(tracefile):
    """{path within lib/uhas: {line: how often it was run}}"""
    files, lines = {}, None
    for record in tracefile.read_text().splitlines():
        kind, _, value = record.partition(":")
        if kind == "SF":
            lines = files.setdefault(pathlib.Path(value).relative_to(LIBRARY), {})
        elif kind == "DA":
            line, times = value.split(",")[:2]
            lines[int(line)] = int(times)
    return files


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tracefile", type=pathlib.Path)
    parser.add_argument("--not-run", required=True, type=pathlib.Path)
    parser.add_argument("--must", required=True, type=float)
    options = parser.parse_args()

    run, all_lines, not_run = collections.Counter(), collections.Counter(), []
    for path, lines in sorted(counts(options.tracefile).items()):
        text = (LIBRARY / path).read_text().splitlines()
        for line, times in sorted(lines.items()):
            for name in (path.parts[0], "lib"):
                all_lines[name] += 1
                run[name] += times > 0
            if times == 0:
                not_run.append(f"{path}:{line}: {text[line - 1].strip()}\n")
    options.not_run.write_text("".join(not_run))

    for name in sorted(all_lines, key=lambda name: (name == "lib", name)):
        print(f"{name:<16} {run[name]:>6} of {all_lines[name]:>6} lines  {100 * run[name] / all_lines[name]:5.1f} %")
    print(f"Not run: {len(not_run)} lines, listed in {options.not_run}")
    if 100 * run["lib"] < options.must * all_lines["lib"]:
        print(f"FAILED: less than {options.must:g} % of the lines of lib", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
