#!/usr/bin/env python3
"""`--version --verbose`, in either order, prints what `--version` prints and the versions of the libraries, which are those that
pkg-config or Debian's package of the library says. A version may have fewer numbers than theirs: 3.0 for 3.0.1.

    versions.py --bin build/dev/bin
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys

# library: (module of pkg-config, package of Debian)
LIBRARIES = {
    "assimp": ("assimp", "libassimp-dev"),
    "CLI11": ("CLI11", "libcli11-dev"),
    "console_bridge": ("console_bridge", "libconsole-bridge-dev"),
    "Eigen": ("eigen3", "libeigen3-dev"),
    "Embree": ("embree", "libembree-dev"),
    "FCL": ("fcl", "libfcl-dev"),
    "HDF5": ("hdf5", "libhdf5-dev"),
    "meshoptimizer": ("meshoptimizer", "libmeshoptimizer-dev"),
    "nlohmann_json": ("nlohmann_json", "nlohmann-json3-dev"),
    "NLopt": ("nlopt", "libnlopt-dev"),
    "tinyxml": ("tinyxml", "libtinyxml-dev"),
    "urdfdom": ("urdfdom", "liburdfdom-dev"),
}


def answer(*command):
    """What a command prints; empty when it is not there or fails."""
    if not shutil.which(command[0]):
        return ""
    done = subprocess.run(command, capture_output=True, text=True)
    return done.stdout.strip() if done.returncode == 0 else ""


def known_versions(module, package):
    """What the system says, as lists of numbers."""
    debian = answer("dpkg-query", "--show", "--showformat=${source:Upstream-Version}", package)
    return [re.match(r"[\d.]+", text)[0].split(".") for text in (answer("pkg-config", "--modversion", module), debian) if text]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    faults, skipped = [], []
    for tool in sorted(parser.parse_args().bin.glob("uhas-*")):
        short, one, other = (answer(tool, *flags) for flags in (["--version"], ["--version", "--verbose"],
                                                                ["--verbose", "--version"]))
        if not short.startswith(f"{tool.name} ") or "assimp" in short:
            faults.append(f"{tool.name} --version prints {short}")
        if one != other or not one.startswith(short + "\n"):
            faults.append(f"{tool.name}: --version, --version --verbose and --verbose --version print {[short, one, other]}")
        libraries = dict(line.rsplit(" ", 1) for line in one.removeprefix(short).split("\n") if line)
        if libraries.keys() != LIBRARIES.keys():
            faults.append(f"{tool.name} tells the versions of {sorted(libraries)}")
    for library, version in libraries.items():
        known = known_versions(*LIBRARIES.get(library, ("", "")))
        numbers = version.split(".")
        if not known:
            skipped.append(library)
        elif len(numbers) < 2 or not any(numbers == other[:len(numbers)] for other in known):
            faults.append(f"{library} {version} is told, {' or '.join('.'.join(other) for other in known)} is installed")
    if skipped:
        print(f"SKIPPED: {', '.join(skipped)}: neither pkg-config nor dpkg-query knows a version")
    print("\n".join(faults) or f"{len(libraries) - len(skipped)} versions agree")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
