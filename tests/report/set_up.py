#!/usr/bin/env python3
"""Installs what the report's tests need of npm, as package-lock.json pins it, into FOLDER. Skips, by name, without the
programs or the registry.

    set_up.py FOLDER
"""

import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77  # ctest's SKIP_RETURN_CODE of this test
NO_NETWORK = ("ENOTFOUND", "EAI_AGAIN", "ECONNREFUSED", "ECONNRESET", "ETIMEDOUT", "ENETUNREACH")  # npm's words
LOCK = pathlib.Path(__file__).with_name("package-lock.json")


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(SKIPPED)


def main():
    folder = pathlib.Path(sys.argv[1])
    for program in ("node", "npm", "chromium"):
        if shutil.which(program) is None:
            skip(f"{program} is not installed")
    complete = folder / "node_modules/.package-lock.json"  # npm writes it last
    copy = folder / LOCK.name
    if complete.exists() and copy.exists() and copy.read_bytes() == LOCK.read_bytes():
        return
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", LOCK.name):
        shutil.copy(LOCK.with_name(name), folder)
    command = ["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--fetch-retries=1",
               "--fetch-retry-mintimeout=1000"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        if any(word in done.stderr for word in NO_NETWORK):
            skip("the npm registry cannot be reached")
        sys.exit(done.stderr)


if __name__ == "__main__":
    main()
