#!/usr/bin/env python3
"""Sums up a run of ctest: one line a suite (the label of its tests), then everything that was skipped, by name.

    summary.py BUILD_FOLDER RESULTS.xml      the file is what `ctest --output-junit` wrote

A test says what it skips, the whole of it or a part, in lines that hold `SKIPPED: reason`.
"""

import collections
import json
import re
import subprocess
import sys
import textwrap
import xml.etree.ElementTree


def suites(build_folder):
    """The label of each test."""
    listing = subprocess.run(["ctest", "--test-dir", build_folder, "--show-only=json-v1"], check=True, capture_output=True)
    suite = {}
    for test in json.loads(listing.stdout)["tests"]:
        labels = [p["value"] for p in test["properties"] if p["name"] == "LABELS"]
        suite[test["name"]] = labels[0][0] if labels else "other"
    return suite


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    build_folder, results = sys.argv[1:]
    suite = suites(build_folder)
    counts = collections.defaultdict(collections.Counter)  # of each suite
    skipped = collections.defaultdict(list)  # tests by reason
    for case in xml.etree.ElementTree.parse(results).getroot().iter("testcase"):
        name = case.get("name")
        reasons = re.findall(r"SKIPPED: *(.*)", case.findtext("system-out") or "")
        if case.find("skipped") is not None:
            result = "skipped"
            reasons = reasons or ["no reason given"]
        else:
            result = "passed" if case.get("status") == "run" else "failed"
        counts[suite[name]][result] += 1
        for reason in reasons:
            skipped[reason].append(name)

    for name, count in sorted(counts.items()):
        print(f"{name + ':':14}", ", ".join(f"{count[word]} {word}" for word in ("passed", "failed", "skipped") if count[word]))
    print(f"skipped: {sum(len(names) for names in skipped.values())}")
    for reason, names in skipped.items():
        print(f"  {reason} ({len(names)}):")
        print(textwrap.fill(" ".join(names), 120, initial_indent="    ", subsequent_indent="    "))
    return 0


if __name__ == "__main__":
    sys.exit(main())
