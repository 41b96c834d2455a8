#!/usr/bin/env python3
"""No file and no JSON that the tools write tells where on the machine it was made: everything is run by absolute paths in a
folder of a name that nothing else has, which must not be found in any byte of the output, unpacked where it is packed.

    no_machine_paths.py --bin build/dev/bin
"""
import argparse
import base64
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import h5py

import real_work


def text_of_hdf5(path):
    """All names, text and attributes of a file."""
    found = []

    def visit(name, item):
        found.append(name)
        found.extend(f"{key} {value!r}" for key, value in item.attrs.items())
        if isinstance(item, h5py.Dataset) and item.dtype.kind in "SO":
            found.append(repr(item[()]))

    with h5py.File(path) as file:
        visit("/", file)
        file.visititems(visit)
    return "\n".join(found).encode()


def contents_of(path):
    """The bytes of a file, and what is packed in it: text of HDF5, base64 of a page."""
    yield path.read_bytes()
    if path.suffix == ".h5":
        yield text_of_hdf5(path)
    if path.suffix == ".html":
        for packed in re.findall(rb"[A-Za-z0-9+/]{64,}={0,2}", path.read_bytes()):
            yield base64.b64decode(packed[:len(packed) // 4 * 4])


def tells(contents, folder):
    """Whether any of them names the folder."""
    return any(folder.name.encode() in content for content in contents)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    bin_folder = parser.parse_args().bin.resolve()
    environment = dict(os.environ, PATH=f"{bin_folder}{os.pathsep}{os.environ['PATH']}", LC_ALL="C")

    def run(command):
        return subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=300)

    faults, searched = [], 0
    with tempfile.TemporaryDirectory(prefix="where-it-was-made-") as name:
        folder = pathlib.Path(name)
        real_work.write_input(folder)
        urdf = folder / "hand.urdf"
        by_file = urdf.read_text().replace('filename="meshes/', f'filename="file://{folder}/meshes/', 4)
        by_package = re.sub(r'filename="meshes/(?=finger)', 'filename="package://hand/meshes/', by_file)
        assert by_package != by_file != urdf.read_text()
        urdf.write_text(by_package)
        environment["ROS_PACKAGE_PATH"] = str(folder.parent)
        (folder / "package.xml").write_text("<package><name>hand</name></package>")

        for command in real_work.commands(folder):
            command += ["--package", f"hand={folder}"] if command[0] != "uhas-retarget" else []
            done = run(command)
            if done.returncode != 0:
                faults.append(f"{' '.join(command)}: {done.stderr.decode()}")
            if tells([done.stdout], folder):
                faults.append(f"{' '.join(command)} prints the folder")
        for path in [folder / "hand.h5", *sorted(folder.glob("out.*"))]:
            searched += 1
            if tells(contents_of(path), folder):
                faults.append(f"{path.name} holds the folder")
        # the search works: a message does name the folder, and so does a file that has it packed
        if not tells([run(["uhas-inspect", str(folder / "missing.h5")]).stderr], folder):
            faults.append("an error message that names the folder goes unnoticed")
        with h5py.File(folder / "planted.h5", "w") as file:
            file.create_dataset("text", data=[str(folder).encode()] * 9, chunks=(9,), compression=9)
        (folder / "planted.html").write_bytes(base64.b64encode(b"x" * 64 + str(folder).encode()))
        for planted in (folder / "planted.h5", folder / "planted.html"):
            if not tells(contents_of(planted), folder):
                faults.append(f"the folder in {planted.name} goes unnoticed")
    print("\n".join(faults) or f"{searched} files and what was printed name no folder of this machine")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
