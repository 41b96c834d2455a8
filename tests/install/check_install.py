#!/usr/bin/env python3
"""Installs a build into an empty folder, moves that folder, and uses what is there as a user would.

    check_install.py build/dev
    check_install.py build/runtime-only --profile hand.h5
    check_install.py build/release/packages          the Debian packages in that folder, unpacked

Public headers compile one by one and need nothing that is not installed; the examples build against the package and run;
pkg-config leads to the same library; uhas::preprocess is found where it was built and refused with a reason where not; the
programs of docs/library.md build and run.
A build without tools cannot make a hand profile: --profile gives it one.
"""

import argparse
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
C_PROGRAM = """#include <stdio.h>

#include "uhas/c/uhas.h"

int main(void) {
  const double action[15] = {0};
  double q[16];
SNIPPET
  return status == UHAS_OK ? 0 : 1;
}
"""
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]


class Failure(Exception):
    pass


def run(*command, **options):
    """stdout of a command; Failure with all it said unless it succeeds."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise Failure(f"{' '.join(map(str, command))}\nexits with {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Installation:
    """The package in `prefix`; `scratch` is for what its user builds."""

    def __init__(self, build, scratch, profile):
        self.prefix, self.scratch, self.profile = scratch / "moved", scratch, profile
        packages = sorted(build.glob("*.deb"))
        for package in packages:
            run("dpkg-deb", "--extract", package, scratch / "root")
        if not packages:
            run("cmake", "--install", build, "--prefix", scratch / "first")
        os.rename(scratch / ("root/usr" if packages else "first"), self.prefix)
        self.library = next(self.prefix.glob("lib*/**/libuhas.so")).parent
        self.has_preprocess = (self.prefix / "bin").exists()

    def make_profile(self):
        hand = self.prefix / "share/uhas/hands/allegro_right/allegro_right.urdf"
        self.profile = self.scratch / "allegro_right.h5"
        run(self.prefix / "bin/uhas-build-profile", "--quiet", hand, "-o", self.profile)

    def build(self, source, build):
        warnings = " ".join(WARNINGS)
        run("cmake", "-S", source, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_CXX_FLAGS={warnings}",
            f"-DCMAKE_C_FLAGS={warnings}")
        run("cmake", "--build", build, "--parallel", 2)

    def check_headers(self):
        """Each alone, so that none leans on what another includes; those of C in C99 too."""
        include = self.prefix / "include"
        headers = sorted(path.relative_to(include) for path in include.rglob("*.h*"))
        libraries = ["runtime", "preprocess"] if self.has_preprocess else ["runtime"]
        listed = [line.split() for line in (ROOT / "lib/public_headers.txt").read_text().splitlines()]
        public = sorted(pathlib.Path("uhas") / header for library, header in listed if library in libraries)
        if headers != public:
            raise Failure(f"installed headers\n{headers}\npublic headers\n{public}")
        for header in headers:
            for compiler in ["c++ -x c++ -std=c++20"] + ["cc -x c -std=c99"] * (header.suffix == ".h"):
                source = self.scratch / "header"
                source.write_text(f'#include "{header}"\n')
                run(*compiler.split(), *WARNINGS, "-fsyntax-only", f"-I{include}", source)

    def check_soname(self):
        major = re.search(r"Version: (\d+)", (self.library / "pkgconfig/uhas.pc").read_text())[1]
        dynamic = run("readelf", "-d", self.library / "libuhas.so")
        if f"soname: [libuhas.so.{major}]" not in dynamic:
            raise Failure(dynamic)

    def run_example(self, example, build):
        profiles = [self.profile] * (2 if "retarget" in example.name else 1)
        program = [sys.executable, example, self.library / "libuhas.so"] if example.suffix == ".py" else [build / example.stem]
        return run(*program, *profiles)

    def check_examples(self):
        """Every numbered source builds, runs and prints; C says what C++ says."""
        source, build = self.prefix / "share/doc/uhas/examples", self.scratch / "examples"
        self.build(source, build)
        printed = {example.stem: self.run_example(example, build) for example in sorted(source.glob("[0-9]*"))}
        silent = [name for name, text in printed.items() if not text]
        if len(printed) < 7 or silent:
            raise Failure(f"{len(printed)} examples, of which print nothing: {silent}")
        if printed["02_solve"] != printed["07_c"]:
            raise Failure(f"C++ prints\n{printed['02_solve']}C prints\n{printed['07_c']}")

    def check_pkg_config(self):
        environment = dict(os.environ, PKG_CONFIG_PATH=str(self.library / "pkgconfig"))
        flags = shlex.split(run("pkg-config", "--cflags", "--libs", "uhas", env=environment))
        program = self.scratch / "solve"
        run("c++", "-std=c++20", self.prefix / "share/doc/uhas/examples/02_solve.cpp", *flags, "-o", program)
        run(program, self.profile, env=dict(os.environ, LD_LIBRARY_PATH=str(self.library)))

    def check_library_page(self):
        """The C++ program of docs/library.md with its lines of CMake, and its lines of C, in a folder with the profile they name."""
        blocks = dict(re.findall(r"^```(cpp|cmake|c)\n(.*?)^```", (ROOT / "docs/library.md").read_text(), re.M | re.S))
        source, build = self.scratch / "library page", self.scratch / "library page build"
        source.mkdir()
        (source / "controller.cpp").write_text(blocks["cpp"])
        (source / "snippet.c").write_text(C_PROGRAM.replace("SNIPPET", blocks["c"]))
        (source / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(library_page LANGUAGES C CXX)\n"
            "add_executable(my_controller controller.cpp)\nadd_executable(snippet snippet.c)\n" + blocks["cmake"]
            + "target_link_libraries(snippet PRIVATE uhas::runtime)\n")
        self.build(source, build)
        shutil.copy(self.profile, build / "allegro_right.h5")
        if run(build / "my_controller", cwd=build).count("\n") != 16:
            raise Failure("the program of docs/library.md does not print 16 joints")
        run(build / "snippet", cwd=build)

    def check_preprocess(self):
        build = self.scratch / "preprocess"
        self.build(HERE / "preprocess", build)
        hand = self.prefix / "share/uhas/hands/allegro_right/allegro_right.urdf"
        if run(build / "build_and_solve", hand) != "16 joints\n":
            raise Failure("build_and_solve does not count 16 joints")

    def check_report(self):
        """The tools carry all that a page is made of."""
        folder = self.scratch / "elsewhere"
        folder.mkdir()
        hand = self.prefix / "share/uhas/hands/allegro_right/allegro_right.urdf"
        run(self.prefix / "bin/uhas-inspect", self.profile, "--html", "report.html", "--urdf", hand, cwd=folder)
        if b'id="uhas-report">{"format":"uhas-report"' not in (folder / "report.html").read_bytes():
            raise Failure("report.html has no document")

    def check_preprocess_refused(self):
        done = subprocess.run(["cmake", "-S", HERE / "preprocess", "-B", self.scratch / "preprocess",
                               f"-DCMAKE_PREFIX_PATH={self.prefix}"], capture_output=True, text=True)
        if done.returncode == 0 or "built without preprocessing" not in done.stderr:
            raise Failure(f"uhas::preprocess is not refused:\n{done.stdout}{done.stderr}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, help="a build folder, built, or a folder of .deb files")
    parser.add_argument("--profile", type=pathlib.Path, help="the hand profile that the examples load")
    options = parser.parse_args()

    with tempfile.TemporaryDirectory(prefix="uhas install ") as folder:  # a space: paths must be quoted everywhere
        package = Installation(options.build, pathlib.Path(folder), options.profile)
        checks = [package.check_headers, package.check_soname, package.check_examples, package.check_pkg_config,
                  package.check_library_page]
        if package.has_preprocess:
            checks = [package.make_profile, *checks, package.check_preprocess, package.check_report]
        else:
            checks.append(package.check_preprocess_refused)
        failed = 0
        for check in checks:
            try:
                check()
                print(f"ok      {check.__name__}")
            except Failure as failure:
                failed += 1
                print(f"FAILED  {check.__name__}: {failure}")
    print(f"{len(checks)} checks, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
