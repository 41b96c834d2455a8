#!/usr/bin/env python3
"""lib/uhas/runtime/README.md, against the room that it leads through.

- the main path has at most 12 files and 1,800 lines, by the command that the page itself gives;
- every source of the room is linked from the page, or is one of the compilations of a kernel that is.
"""

import pathlib
import re
import subprocess
import sys

ROOM = pathlib.Path(__file__).resolve().parents[2] / "lib/uhas/runtime"
PAGE = (ROOM / "README.md").read_text()
MOST_FILES, MOST_LINES = 12, 1800


def check_size():
    command = re.search(r"^    (grep .*)$", PAGE, re.M)[1]
    run = subprocess.run(["sh", "-c", command], cwd=ROOM, capture_output=True, text=True, check=True)
    if run.stderr:
        yield f"the command says: {run.stderr.strip()}"
    files, lines = map(int, re.fullmatch(r"(\d+) files, (\d+) lines\n", run.stdout).groups())
    path = re.search(r"^## Read in this order$(.*?)^## ", PAGE, re.M | re.S)[1]
    if files != len(re.findall(r"^\d+\. ", path, re.M)):
        yield f"the command counts {files} files, the list has other items"
    if files > MOST_FILES or lines > MOST_LINES:
        yield f"the main path has {files} files and {lines} lines; at most {MOST_FILES} and {MOST_LINES}"


def check_places():
    linked = {(ROOM / target).resolve() for target in re.findall(r"\]\(([^)#\s]+)\)", PAGE)}
    yield from (f"links to {path}, which is not there" for path in sorted(linked) if not path.exists())
    for source in sorted(path for ending in ("*.hpp", "*.cpp") for path in ROOM.rglob(ending)):
        kernel = source.with_name(re.sub(r"_(baseline|avx2|avx512)\.cpp$", ".hpp", source.name))
        if not {source, kernel} & linked:
            yield f"does not place {source.relative_to(ROOM)}"


def main():
    faults = [*check_size(), *check_places()]
    print("\n".join(f"runtime/README.md: {fault}" for fault in faults) if faults else "the page leads through the room")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
