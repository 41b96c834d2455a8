#!/usr/bin/env python3
"""What the Debian packages of a build say and hold; check_install.py uses what is in them.

    check_packages.py build/release/packages

Three packages of the project's version; each names the libraries that its programs load, and the others the version that it was
built with; no file is in two; libraries, headers and tools are in the package that they belong to.
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

# package: (a package that it must depend on, patterns that each match a file of it, a pattern that matches none)
EXPECTED = {
    "libuhas0": ("libhdf5", [r"/libuhas\.so\.0$", r"/LICENSE$"], r"/bin/|/include/|preprocess"),
    "libuhas-dev": ("libuhas0", [r"/libuhas\.so$", r"/uhas/c/uhas\.h$", r"/uhas-config\.cmake$", r"/uhas\.pc$", r"/02_solve\.cpp$"], r"/bin/|\.so\.\d"),
    "uhas-tools": ("libuhas0", [r"/bin/uhas-solve$", r"/man1/uhas-solve\.1$", r"/man5/uhas-hand-profile\.5$", r"/man7/uhas\.7$",
                                r"/bash-completion/completions/uhas-solve$", r"/vendor-completions/_uhas-solve$",
                                r"/vendor_completions\.d/uhas-solve\.fish$", r"/libuhas_preprocess\.so\.0$",
                                r"/uhas/schemas/hand-profile-v1\.md$", r"/allegro_right\.urdf$"], r"/include/|/libuhas\.so"),
}


def dpkg_deb(*arguments):
    return subprocess.run(["dpkg-deb", *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def files_of(package):
    """Paths of what is no folder."""
    lines = dpkg_deb("--contents", package).splitlines()
    return [re.match(r"(?:\S+\s+){5}\.(\S+)", line)[1] for line in lines if not line.startswith("d")]


def check_package(name, package, version):
    stated = dict(re.findall(r"^ ?(\S+): (.*)$", dpkg_deb("--field", package), re.M))
    dependency, patterns, foreign = EXPECTED[name]
    if stated["Version"] != version:
        yield f"has version {stated['Version']}, the project {version}"
    for other in EXPECTED:
        if re.search(rf"\b{other}\b", stated["Depends"]) and f"{other} (= {version})" not in stated["Depends"]:
            yield f"takes {other} of another version: {stated['Depends']}"
    if not re.search(rf"\b{dependency}", stated["Depends"]) or (name != "libuhas-dev" and "libc6" not in stated["Depends"]):
        yield f"depends on {stated['Depends']} only"
    paths = files_of(package)
    yield from (f"has no file {pattern}" for pattern in patterns if not any(re.search(pattern, path) for path in paths))
    yield from (f"has {path}" for path in paths if re.search(foreign, path) or not path.startswith("/usr/"))


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    version = re.search(r"project\(uhas VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
    packages = {path.name.split("_")[0]: path for path in pathlib.Path(sys.argv[1]).glob("*.deb")}
    faults = [f"the packages are {sorted(packages)}"] if packages.keys() != EXPECTED.keys() else []
    owners = {}
    for name, package in sorted(packages.items()):
        faults += [f"{name}: {fault}" for fault in check_package(name, package, version)] if name in EXPECTED else []
        for path in files_of(package):
            if path in owners:
                faults.append(f"{path} is in {name} and in {owners[path]}")
            owners[path] = name
    print("\n".join(faults) if faults else f"{len(packages)} packages, {len(owners)} files")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
