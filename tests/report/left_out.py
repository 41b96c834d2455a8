#!/usr/bin/env python3
"""Checks what comes of a build without the report.

    left_out.py INSPECT CMAKE SOURCE_FOLDER

INSPECT is uhas-inspect, linked with what stands in for the report: --html is an error that says how to get it. CMake leaves the report
out where told, and where it cannot be built unless told to build it.
"""

import subprocess
import sys
import tempfile

ERROR = ("uhas-inspect: error: this build of uhas has no HTML reports; install the packages that packages/debian.sh lists for web pages "
         "and configure with -DUHAS_BUILD_REPORT=ON\n")
CANNOT = "-DUHAS_WASM_CXX=/bin/false"
# options, whether CMake accepts them, what it says
CONFIGURATIONS = [
    (["-DUHAS_BUILD_REPORT=OFF"], True, ""),
    ([CANNOT], True, "HTML reports are left out: WebAssembly cannot be compiled here"),
    ([CANNOT, "-DUHAS_BUILD_REPORT=ON"], False, "WebAssembly cannot be compiled here"),
]


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)


def main():
    inspect, cmake, source = sys.argv[1:]
    faults = []
    done = run(inspect, "hand.h5", "--html", "hand.html")
    if (done.returncode, done.stdout, done.stderr) != (1, "", ERROR):
        faults.append(f"--html: {done}")
    for options, accepted, words in CONFIGURATIONS:
        with tempfile.TemporaryDirectory() as folder:
            done = run(cmake, "-S", source, "-B", folder, "-DUHAS_BUILD_TESTS=OFF", *options)
        if (done.returncode == 0) != accepted or words not in " ".join((done.stdout + done.stderr).split()):
            faults.append(f"{' '.join(options)}: {done.stdout}{done.stderr}")
    print("\n".join(faults) or f"the error is right, and so are {len(CONFIGURATIONS)} configurations")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
