#!/usr/bin/env python3
"""Runs the command tests of one folder: shell scripts, each of which ends in what must come of it.

A case is <folder>/<case>.sh, run by `sh` in an empty folder that holds `hand` (the folder of the project's own hand) and
`allegro_right.h5` in `profile`. Comments at its end are its outcome, under the shell's own names:

    uhas-inspect profile/allegro_right.h5 -g fingers.4.name
    #? 1
    #2> uhas-inspect: error: there is no value fingers.4.name; fingers holds 0 to 3

`#?` is the exit code, left out when it is 0; `#>` is a line of stdout, `#2>` a line of stderr. `#>%` or `#2>%` says that the line
before it has no newline at its end.

Success leaves nothing but warnings on stderr; a case that must leave more says why in a line `# stderr: ...` of its script.
--refresh writes the outcomes instead of comparing them; read the difference before you commit it.
"""
import argparse
import difflib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
import transcript  # noqa: E402

HAND = HERE.parent.parent / "hands" / "allegro_right"
OUTCOME = re.compile(r"(?:^#(?:\?|2?>).*\n?)*\Z", re.M)


def read_case(path):
    """The script of a case and its outcome."""
    text = path.read_bytes().decode()
    start = OUTCOME.search(text).start()
    return text[:start], text[start:]


def run_case(path, environment, profile, timeout):
    """Exit code, stdout and stderr of a case; bytes that are no UTF-8 become `\\x..`."""
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(HAND, os.path.join(folder, "hand"))
        os.mkdir(os.path.join(folder, "profile"))
        shutil.copy(profile, os.path.join(folder, "profile"))
        done = subprocess.run(["sh", str(path)], cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=timeout)
    return done.returncode, *(stream.decode(errors="backslashreplace") for stream in (done.stdout, done.stderr))


def marked(mark, text):
    """The lines of `text`, each behind a mark."""
    *lines, rest = text.split("\n")
    marked_lines = [f"{mark} {line}\n" if line else f"{mark}\n" for line in lines]
    return "".join(marked_lines) + (f"{mark} {rest}\n{mark}%\n" if rest else "")


def outcome(code, stdout, stderr):
    return (f"#? {code}\n" if code else "") + marked("#>", stdout) + marked("#2>", stderr)


def compare(name, path, result):
    """Prints the verdict and every difference; True when there is none."""
    (script, expected), found = read_case(path), outcome(*result)
    code, _, stderr = result
    talks = code == 0 and transcript.talk(stderr) and "# stderr: " not in script
    print(f"{'FAILED' if expected != found or talks else 'ok':6}  {name}")
    if talks:
        print("success leaves more than warnings on stderr")
    sys.stdout.writelines(difflib.unified_diff(expected.splitlines(True), found.splitlines(True), "expected", "found"))
    return expected == found and not talks


def refresh(path, result):
    script, _ = read_case(path)
    path.write_bytes((script.removesuffix("\n") + "\n" + outcome(*result)).encode())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="folder of cases, for example uhas-solve")
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    parser.add_argument("--refresh", action="store_true", help="write the outcomes instead of comparing")
    parser.add_argument("--timeout", type=float, default=120, help="seconds that a case may take")
    options = parser.parse_args()

    cases = sorted((HERE / options.folder).glob("*.sh"))
    environment = dict(os.environ, PATH=f"{options.bin.resolve()}{os.pathsep}{os.environ['PATH']}", LC_ALL="C")
    failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        profile = os.path.join(scratch, "allegro_right.h5")
        subprocess.run(["uhas-build-profile", "--quiet", HAND / "allegro_right.urdf", "-o", profile], env=environment, check=True)
        for path in cases:
            result = run_case(path, environment, profile, options.timeout)
            if options.refresh:
                refresh(path, result)
            else:
                failed += not compare(f"{options.folder}/{path.stem}", path, result)
    if not cases:
        print(f"no cases in {HERE / options.folder}")
    print(f"{len(cases)} cases, {failed} failed")
    return 1 if failed or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
