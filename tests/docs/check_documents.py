#!/usr/bin/env python3
"""What the Markdown pages of the repository say of it, against it.

- every relative link leads to a file, and to a heading where it names one;
- so does every `docs/<page>.md#<heading>` in code, and no comment cites a document that is not in the repository;
- every source or script that a page names in a code span is there;
- CONTRIBUTING.md maps every room of lib/uhas, every top-level folder and every suite of tests, and none that is not there;
- it describes every preset that is built, and none that is not there;
- each entry of CHANGELOG.md says whom it concerns: `lib:`, `cli:`, `format:` or `doc:`.
"""

import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONTRIBUTING = (ROOT / "CONTRIBUTING.md").read_text()


def tracked(*patterns):
    listing = subprocess.run(["git", "-C", ROOT, "ls-files", *patterns], capture_output=True, text=True, check=True)
    return listing.stdout.splitlines()


def folders_in(folder):
    """Names of the folders with tracked files right in `folder`, hidden ones left out."""
    prefix = f"{folder}/" if folder else ""
    rests = [path.removeprefix(prefix) for path in tracked(folder or ".")]
    return {rest.split("/")[0] for rest in rests if "/" in rest and not rest.startswith(".")}


def anchors(page):
    """Names that links into a page can use: its own, and those that GitHub makes of its headings."""
    text = page.read_text()
    headings = re.findall(r"^#+ (.*?)(?: \{#.*\})?$", text, re.M)
    return set(re.findall(r'<a (?:id|name)="(.*?)"', text)) | {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def check_links():
    for name in tracked("*.md"):
        page = ROOT / name
        text = re.sub(r"^```.*?^```", "", page.read_text(), flags=re.M | re.S)
        for target in re.findall(r"\]\(([^)\s]+)\)", text):
            path, _, anchor = target.partition("#")
            if re.match(r"\w+:", target):
                continue
            there = page.parent / path if path else page
            if not there.exists():
                yield f"{name}: links to {target}, which is not there"
            elif anchor and anchor not in anchors(there):
                yield f"{name}: links to {target}, which has no such heading"


def code_files():
    """[(name, text)] of sources, scripts and headers; this file speaks of what it looks for."""
    for name in tracked("lib", "tools", "tests", "examples", "cmake"):
        if name != "tests/docs/check_documents.py" and re.search(r"\.(hpp|cpp|h|c|py|sh|cmake|txt|js)$", name):
            yield name, (ROOT / name).read_text()


def check_references():
    for name, text in code_files():
        for page, anchor in re.findall(r"docs/([\w-]+\.md)(?:#([\w-]+))?", text):
            there = ROOT / "docs" / page
            if not there.exists():
                yield f"{name}: refers to docs/{page}, which is not there"
            elif anchor and anchor not in anchors(there):
                yield f"{name}: refers to docs/{page}#{anchor}, which has no such heading"
        for citation in re.findall(r"\bdesign,?[\s/#*<]+\d[\d.]*", text):
            yield f"{name}: cites '{' '.join(citation.split())}', which is not in the repository: cite docs/method.md#<heading>"


def check_named_files():
    files = ["/" + name for name in tracked()]
    for name in tracked("README.md", "CONTRIBUTING.md", "docs/*.md"):
        text = re.sub(r"^```.*?^```", "", (ROOT / name).read_text(), flags=re.M | re.S)
        for span in re.findall(r"`([\w./-]+\.(?:hpp|cpp|h|py|sh|cmake|js))`", text):
            if not any(file.endswith("/" + span) for file in files):
                yield f"{name}: names {span}, which is not there"


def difference(named, there, what):
    yield from (f"CONTRIBUTING.md does not name {what} {name}" for name in sorted(there - named))
    yield from (f"CONTRIBUTING.md names {what} {name}, which is not there" for name in sorted(named - there))


def check_map():
    house = CONTRIBUTING.split("## The house\n\n")[1].split("\n\n")[0]
    parts = re.split(r"^    (\S+)/ ", house, flags=re.M)  # "", folder, its text, ...
    texts = dict(zip(parts[1::2], parts[2::2]))
    nested = {folder: {name for names in re.findall(r"^      ((?:\w+/ +)+)", text, re.M) for name in re.findall(r"\w+", names)}
              for folder, text in texts.items()}
    yield from difference({folder.split("/")[0] for folder in texts}, folders_in(""), "folder")
    yield from difference(nested["lib/uhas"], folders_in("lib/uhas"), "room")
    yield from difference(nested["tests"], folders_in("tests") - {"unit", "support"}, "suite")


def check_presets():
    presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
    rows = re.findall(r"^\| (`.*?) \|", CONTRIBUTING.split("| preset |")[1].split("\n\n")[0], re.M)
    named = {name for row in rows for name in re.findall(r"`([\w-]+)`", row)}
    yield from difference(named, {preset["name"] for preset in presets if not preset.get("hidden")}, "preset")


def check_changelog():
    for line in re.findall(r"^- .*", (ROOT / "CHANGELOG.md").read_text(), re.M):
        if not re.match(r"- (lib|cli|format|doc): ", line):
            yield f"CHANGELOG.md: says not whom it concerns: {line}"


def main():
    faults = [*check_links(), *check_references(), *check_named_files(), *check_map(), *check_presets(), *check_changelog()]
    print("\n".join(faults) if faults else "the pages agree with the repository")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
