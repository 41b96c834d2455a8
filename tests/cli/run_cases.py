#!/usr/bin/env python3
"""Runs the command tests of one tool and compares exit code, stdout and stderr with what is on file.

A case is <tool>/<case>.sh, run by `sh` in an empty folder that holds `hand` (the folder of the project's own hand) and
`allegro_right.h5` in `profile`. Beside it stand <case>.exit (0 when absent), <case>.stdout and <case>.stderr (empty
when absent). Success leaves nothing but warnings on stderr; a case that must leave more says why in a line `# stderr: ...` of
its script. --refresh writes these files instead; read the difference before you commit it.
"""
import argparse
import difflib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
HAND = HERE.parent.parent / "hands" / "allegro_right"


def run_case(script, environment, profile, timeout):
    """Exit code, stdout and stderr of a case, as the text of its three files."""
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(HAND, os.path.join(folder, "hand"))
        os.mkdir(os.path.join(folder, "profile"))
        shutil.copy(profile, os.path.join(folder, "profile"))
        done = subprocess.run(["sh", str(script)], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=timeout)
    return {"exit": f"{done.returncode}\n", "stdout": done.stdout, "stderr": done.stderr}


def expected(script, kind):
    path = script.with_suffix("." + kind)
    default = "0\n" if kind == "exit" else ""
    return path.read_text() if path.exists() else default


def compare(name, script, results):
    """Prints the verdict and every difference; True when there is none."""
    wrong = [kind for kind, text in results.items() if text != expected(script, kind)]
    talk = [line for line in results["stderr"].splitlines() if ": warning: " not in line]
    talks = results["exit"] == "0\n" and talk and "# stderr: " not in script.read_text()
    print(f"{'FAILED' if wrong or talks else 'ok':6}  {name}")
    if talks:
        print("success leaves more than warnings on stderr")
    for kind in wrong:
        sys.stdout.writelines(difflib.unified_diff(expected(script, kind).splitlines(True), results[kind].splitlines(True),
                                                   f"expected {kind}", f"found {kind}"))
    return not wrong and not talks


def refresh(script, results):
    for kind, text in results.items():
        path = script.with_suffix("." + kind)
        if text == ("0\n" if kind == "exit" else ""):
            path.unlink(missing_ok=True)
        else:
            path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tool", help="folder of cases, for example uhas-solve")
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    parser.add_argument("--refresh", action="store_true", help="write the expected files instead of comparing")
    parser.add_argument("--timeout", type=float, default=120, help="seconds that a case may take")
    options = parser.parse_args()

    scripts = sorted((HERE / options.tool).glob("*.sh"))
    environment = dict(os.environ, PATH=f"{options.bin.resolve()}{os.pathsep}{os.environ['PATH']}", LC_ALL="C")
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        profile = os.path.join(folder, "allegro_right.h5")
        subprocess.run(["uhas-build-profile", "--quiet", HAND / "allegro_right.urdf", "-o", profile], env=environment, check=True)
        for script in scripts:
            results = run_case(script, environment, profile, options.timeout)
            if options.refresh:
                refresh(script, results)
            else:
                failed += not compare(f"{options.tool}/{script.stem}", script, results)
    if not scripts:
        print(f"no cases in {HERE / options.tool}")
    print(f"{len(scripts)} cases, {failed} failed")
    return 1 if failed or not scripts else 0


if __name__ == "__main__":
    sys.exit(main())
