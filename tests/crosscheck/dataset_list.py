"""What schemas/hand-profile-v1.datasets.json asks of an open hand profile (h5py): every dataset, its type, shape and units, and
the rules for its values."""

import json
import pathlib
import re

import h5py
import numpy as np

LIST_FILE = pathlib.Path(__file__).resolve().parents[2] / "schemas/hand-profile-v1.datasets.json"
TYPES = {"real": np.dtype("<f8"), "int": np.dtype("<i4"), "bool": np.dtype("u1")}
LARGEST = 1e6  # of a real
TOLERANCE = 1e-6  # of unit vectors and rotations


def load_list():
    """The document: `profile_version`, and `datasets`, dictionaries as schemas/dataset-list.schema.json describes them."""
    return json.loads(LIST_FILE.read_text())


def is_rigid(T):
    R = T[..., :3, :3]
    last_row = (T[..., 3, :] == [0, 0, 0, 1]).all(-1)
    orthonormal = np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3)).max((-1, -2)) <= TOLERANCE
    return last_row & orthonormal & (np.linalg.det(R) > 0)


RULES = {
    "name": lambda texts: [len(text) > 0 for text in texts],
    "sha256": lambda texts: [re.fullmatch(rb"[0-9a-f]{64}", text) is not None for text in texts],
    "unit_vector": lambda a: np.abs(np.linalg.norm(a, axis=-1) - 1) <= TOLERANCE,
    "rigid_transform": is_rigid,
    "azimuth": lambda angle: (angle > -np.pi) & (angle <= np.pi),
    "polar_angle": lambda angle: (angle >= 0) & (angle <= np.pi),
}


class Refusal(ValueError):
    """A dataset breaks the format; the message names it."""


def require(holds, path, problem):
    if not holds:
        raise Refusal(f"{path} {problem}")


def check_type(dataset, entry):
    if entry["type"] == "text":
        require(dataset.dtype.kind == "S", dataset.name[1:], "is not of fixed-length strings")
    else:
        require(dataset.dtype == TYPES[entry["type"]], dataset.name[1:], f"is not {entry['type']}")


def check_shape(dataset, entry, rows):
    """`rows` maps the letters met so far to numbers of rows, and learns the others."""
    path, shape = dataset.name[1:], entry["shape"]
    require(dataset.ndim == len(shape), path, f"has {dataset.ndim} dimensions, not {len(shape)}")
    for extent, expected in zip(dataset.shape, shape):
        if expected != "any":
            expected = rows.setdefault(expected, extent) if isinstance(expected, str) else expected
            require(extent == expected, path, f"has shape {dataset.shape}, not {shape}")


def check_list(dataset, offsets, entry, rows):
    path = offsets.name[1:]
    require(offsets.dtype == TYPES["int"] and offsets.shape == (rows[entry["shape"][0]] + 1,), path, "is not int [rows + 1]")
    bounds = offsets[:]
    require(bounds[0] == 0 and (np.diff(bounds) >= 0).all(), path, "does not start at 0 and increase")
    require(dataset.shape == (bounds[-1],), dataset.name[1:], f"has shape {dataset.shape}, its offsets end at {bounds[-1]}")


def check_values(values, entry, path, row_counts):
    """`row_counts` of every group, for indices."""
    if entry["type"] == "text":
        for text in values.ravel():
            try:
                text.decode()
            except UnicodeDecodeError:
                raise Refusal(f"{path} is not UTF-8") from None
    elif entry["type"] == "bool":
        require((values <= 1).all(), path, "is neither 0 nor 1")
    else:
        require(np.isfinite(values).all() and (np.abs(values) <= LARGEST).all(), path, "is not finite or beyond 1e6")
    if "minimum" in entry:
        require((values >= entry["minimum"]).all(), path, f"is below {entry['minimum']}")
    if "maximum" in entry:
        require((values <= entry["maximum"]).all(), path, f"is above {entry['maximum']}")
    if "index_of" in entry:
        lowest, count = -1 if entry.get("or_none") else 0, row_counts[entry["index_of"]]
        require(((values >= lowest) & (values < count)).all(), path, f"is no row of {entry['index_of']}")
    if "is" in entry:
        require(np.all(RULES[entry["is"]](values.ravel() if entry["type"] == "text" else values)), path, f"is no {entry['is']}")


def entries_of(version):
    """Those of the list that files of this version have."""
    return [entry for entry in load_list()["datasets"] if entry.get("since", [1, 0]) <= list(version)]


def check(file):
    """Raises Refusal unless every dataset of its version is in the open `file` as the list says; others are ignored."""
    entries = entries_of(file.attrs["version"])
    rows, row_counts = {}, {}
    for entry in entries:
        path = entry["path"]
        dataset = file.get(path)
        require(isinstance(dataset, h5py.Dataset), path, "is missing or is no dataset")
        check_type(dataset, entry)
        if entry.get("list"):
            offsets = file.get(path + "_offsets")
            require(isinstance(offsets, h5py.Dataset), path + "_offsets", "is missing or is no dataset")
            check_list(dataset, offsets, entry, rows)
        else:
            check_shape(dataset, entry, rows)
            if dataset.ndim:
                row_counts.setdefault(path.split("/")[0], dataset.shape[0])
    for entry in entries:
        check_values(np.asarray(file[entry["path"]][()]), entry, entry["path"], row_counts)


def names_and_units(version):
    """{path: units or None} of every dataset that a file of this version has, offsets included."""
    result = {}
    for entry in entries_of(version):
        result[entry["path"]] = entry.get("units")
        if entry.get("list"):
            result[entry["path"] + "_offsets"] = None
    return result
