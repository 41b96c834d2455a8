#!/usr/bin/env python3
"""Makes the golden files of hand profiles that are not there yet, and adds them to SHA256SUMS.

    make_golden.py --bin build/dev/bin

A golden file is made once and never again: it stands for the files that people have. So an existing file is left alone, and a
new version of the format adds files under its own name. What each must lead to stands in check_golden.py and <file>.stderr.

good/minimal-*.h5 is written by h5py from schemas/hand-profile-v1.md alone: one joint, nothing optional. good/full-*.h5 and
good/left-*.h5 are hands of the repository, by uhas-build-profile with few samples. bad/ holds what becomes of the minimal file.
"""

import argparse
import hashlib
import pathlib
import subprocess
import sys

import h5py
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests/crosscheck"))
import dataset_list  # noqa: E402
from read_profile import user_block  # noqa: E402

REAL_HANDS = {"full": "shadow_right", "left": "allegro_left"}

# One finger of one hinge at the palm centre, LENGTH long. Wrapped, its tip is on the sphere that touches the palm there:
# LENGTH = 2 r sin(q).
LENGTH = 0.2
RADIUS = 2 * LENGTH / np.pi
Q_SPHERE = np.arcsin(LENGTH / (2 * RADIUS))
MINIMAL = {
    "hand/name": "minimal", "hand/palm_link": "palm", "hand/root_link": "palm", "hand/T_root_palm": np.eye(4),
    "sphere/T_palm_sphere": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, RADIUS], [0, 0, 0, 1]],
    "sphere/radius": RADIUS, "sphere/radius_scale": 1, "sphere/mean_tip_distance": LENGTH,
    "joints/name": ["hinge"], "joints/parent": [-1], "joints/mimic_master": [-1], "joints/T_parent_joint": [np.eye(4)],
    "joints/axis": [[0, -1, 0]], "joints/upper": [1.5], "joints/class": [1], "joints/encompassing_motion": [0.1],
    "joints/margin": [1], "joints/q_sphere": [Q_SPHERE], "joints/q_closed": [1.5],
    "links/name": ["palm", "finger"], "links/joint": [-1, 0], "links/T_joint_link": [np.eye(4)] * 2,
    "fingers/name": ["finger"], "fingers/slots": [[1] * 5], "fingers/joints": [0], "fingers/joints_offsets": [0, 1],
    "fingers/tip_link": [1], "fingers/p_tip_link": [[LENGTH, 0, 0]], "fingers/pad_normal_link": [[0, 0, 1]],
    "fingers/tip_distance": [LENGTH], "fingers/tip_phi": [2 * Q_SPHERE], "fingers/lateral_table": [-1],
}
ROWS = {"J": 1, "L": 2, "F": 1}  # of the groups that have any


def version_text():
    return ".".join(map(str, dataset_list.load_list()["profile_version"]))


def write_dataset(file, path, entry_type, values, units=None):
    if entry_type == "text":
        width = max([1, *(len(text) for text in np.ravel(values))])
        values = np.array(values, dtype=f"S{width}")
    else:
        values = np.array(values, dtype=dataset_list.TYPES[entry_type])
    dataset = file.create_dataset(path, data=values, track_times=False)
    if units:
        dataset.attrs["units"] = np.bytes_(units)


def write_minimal(path):
    """What MINIMAL does not say is zero or empty, as far as the shape has rows."""
    with h5py.File(path, "w", userblock_size=512, libver=("v108", "v108")) as file:
        file.attrs["format"] = np.bytes_("uhas-hand-profile")
        file.attrs["version"] = np.array(dataset_list.load_list()["profile_version"], "<i4")
        for entry in dataset_list.load_list()["datasets"]:
            name, shape = entry["path"], [ROWS.get(extent, 0) if isinstance(extent, str) else extent for extent in entry["shape"]]
            empty = [""] * shape[0] if shape else ""
            default = empty if entry["type"] == "text" else np.zeros(shape)
            write_dataset(file, name, entry["type"], MINIMAL.get(name, default), entry.get("units"))
            if entry.get("list"):
                offsets = name + "_offsets"
                write_dataset(file, offsets, "int", MINIMAL.get(offsets, np.zeros(shape[0] + 1)))
    seal(path, version_text())


def seal(path, version):
    data = path.read_bytes()
    path.write_bytes(user_block(data, version) + data[512:])


def edited(change, version=None):
    """A maker: the minimal profile, edited with h5py and sealed."""

    def make(path, minimal):
        path.write_bytes(minimal)
        with h5py.File(path, "r+") as file:
            change(file)
        seal(path, version or version_text())

    return make


def replaced(name, make_dataset):
    """A maker: one dataset of the minimal profile replaced."""

    def change(file):
        del file[name]
        make_dataset(file, name)

    return edited(change)


def set_value(name, index, value):
    def change(file):
        file[name][index] = value

    return edited(change)


def bytes_of(function):
    """A maker: a function of the bytes of the minimal profile."""
    return lambda path, minimal: path.write_bytes(function(minimal))


def flipped(data):
    position = len(data) // 2
    return data[:position] + bytes([data[position] ^ 1]) + data[position + 1 :]


def make_alien(path, minimal):
    with h5py.File(path, "w", libver=("v108", "v108")) as file:
        file.create_dataset("images", data=np.zeros((2, 2)), track_times=False)


def add_newer(file):
    """What a later minor version may bring."""
    major, minor = file.attrs["version"]
    file.attrs["version"] = np.array([major, minor + 7], "<i4")
    file.attrs["author"] = np.bytes_("someone")
    file.create_dataset("joints/stiffness", data=[1.0], dtype="<f4", track_times=False)
    file.create_dataset("skin/colour", data=np.zeros((1, 3), "u1"), track_times=False)


def newer_version():
    major, minor = dataset_list.load_list()["profile_version"]
    return f"{major}.{minor + 7}"


def virtual(file, name):
    layout = h5py.VirtualLayout(shape=(1,), dtype="<f8")
    layout[:] = h5py.VirtualSource("other.h5", "x", shape=(1,))
    file.create_virtual_dataset(name, layout)


GOOD_EDITS = {"newer_minor": edited(add_newer, newer_version())}

BAD = {
    "empty": bytes_of(lambda data: b""),
    "not_hdf5": bytes_of(lambda data: b"<?xml version='1.0'?><robot name='hand'/>\n"),
    "alien_hdf5": make_alien,
    "truncated_head": bytes_of(lambda data: data[:100]),
    "truncated": bytes_of(lambda data: data[: len(data) // 2]),
    "appended": bytes_of(lambda data: data + b"\n"),
    "bit_flipped": bytes_of(flipped),
    "older_major": edited(lambda file: file.attrs.__setitem__("version", np.array([0, 9], "<i4")), "0.9"),
    "wrong_major": edited(lambda file: file.attrs.__setitem__("version", np.array([2, 0], "<i4")), "2.0"),
    "two_versions": edited(lambda file: file.attrs.__setitem__("version", np.array([1, 3], "<i4"))),
    "sealed_text": bytes_of(lambda data: user_block(bytes(512) + b"no HDF5", version_text()) + b"no HDF5"),
    "no_format": edited(lambda file: file.attrs.__delitem__("format")),
    "missing_dataset": edited(lambda file: file.__delitem__("joints/axis")),
    "wrong_type": replaced("sphere/radius", lambda file, name: file.create_dataset(name, data=0.1, dtype="<f4")),
    "wrong_shape": replaced("joints/axis", lambda file, name: file.create_dataset(name, data=np.zeros((1, 4)))),
    "nan": set_value("sphere/radius", (), np.nan),
    "no_rotation": set_value("sphere/T_palm_sphere", (0, 0), 2),
    "own_parent": set_value("joints/parent", 0, 0),
    "unclosed_slot": set_value("fingers/slots", (0, 3), 0),
    "huge_dimensions": replaced("correspondences/link", lambda file, name: file.create_dataset(
        name, shape=(2**40,), dtype="<i4", chunks=(1024,))),
    "huge_values": edited(lambda file: file.create_dataset("skin", shape=(2**20, 2**20), dtype="u1", chunks=(1, 1024))),
    "soft_link": edited(lambda file: file.__setitem__("gelenke", h5py.SoftLink("/joints"))),
    "external_link": edited(lambda file: file.__setitem__("passwd", h5py.ExternalLink("/etc/passwd", "/x"))),
    "external_storage": replaced("joints/lower", lambda file, name: file.create_dataset(
        name, shape=(1,), dtype="<f8", external=[("/etc/passwd", 0, 8)])),
    "virtual_storage": replaced("joints/lower", virtual),
    "variable_length": replaced("joints/name", lambda file, name: file.create_dataset(name, data=["hinge"], dtype=h5py.string_dtype())),
    "compound": edited(lambda file: file.create_dataset("skin", data=np.zeros(1, [("x", "<f8")]))),
    "shuffled": replaced("joints/lower", lambda file, name: file.create_dataset(name, data=[0.0], chunks=(1,), shuffle=True)),
    "nested": edited(lambda file: file.create_group("a/b/c/d/e/f")),
}


def build_profile(bin_folder, hand, path):
    subprocess.run([bin_folder / "uhas-build-profile", "--quiet", ROOT / f"hands/{hand}/{hand}.urdf", "--samples", "400",
                    "-o", path], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    options = parser.parse_args()

    version = version_text()
    minimal = HERE / f"good/minimal-{version}.h5"
    makers = {minimal: lambda path: write_minimal(path)}
    makers |= {HERE / f"good/{name}-{version}.h5": lambda path, hand=hand: build_profile(options.bin, hand, path)
               for name, hand in REAL_HANDS.items()}
    makers |= {HERE / f"{folder}/{name}-{version}.h5": lambda path, make=make: make(path, minimal.read_bytes())
               for folder, edits in (("good", GOOD_EDITS), ("bad", BAD)) for name, make in edits.items()}
    with open(HERE / "SHA256SUMS", "a") as sums:
        for path, make in makers.items():
            if not path.exists():
                make(path)
                sums.write(f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.relative_to(HERE)}\n")
                print(f"made {path.relative_to(HERE)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
