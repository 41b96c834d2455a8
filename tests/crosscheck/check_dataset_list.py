#!/usr/bin/env python3
"""The dataset list of the profile format against everything that must agree with it.

    check_dataset_list.py --bin build/dev/bin --profile PROFILE

- the page: schemas/hand-profile-v1.md has the same datasets with the same types, shapes and units;
- the writer: PROFILE, written by the library, has these datasets and no other, of the list's version;
- the readers, `uhas-inspect --validate` and the second reader: each refuses PROFILE with one dataset removed, or of another
  type or shape, or with a value that the list does not allow, and names that dataset.
"""

import argparse
import functools
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy as np

import dataset_list
import read_profile

PAGE = dataset_list.LIST_FILE.with_name("hand-profile-v1.md")


def page_datasets():
    """[(path, type, shape as text, whether a list, units)] of the tables of the page."""
    text = PAGE.read_text().split("\n## Datasets")[1].split("\n## ")[0]
    for section in re.split(r"^### /", text, flags=re.M)[1:]:
        group = section.split("\n")[0]
        for names, meaning in re.findall(r"^\| (`[^|]*`) \| (.*?) \|", section, re.M):
            kind, shape, is_list, units = re.fullmatch(r"(\w+)(?: \[(.*?)\])?( \*list\*)?(?:, (.*))?", meaning).groups()
            names = re.findall(r"`(.*?)`", names)
            each = units.split(" and ") if units and units.count(" and ") + 1 == len(names) > 1 else [units] * len(names)
            for name, unit in zip(names, each):
                yield f"{group}/{name}", kind, shape, bool(is_list), unit


def compare_page(entries):
    def listed(entry):
        is_list = entry.get("list", False)
        shape = None if is_list or not entry["shape"] else ", ".join(map(str, entry["shape"]))
        return entry["path"], entry["type"], shape, is_list, entry.get("units")

    on_page, in_list = set(page_datasets()), {listed(entry) for entry in entries}
    yield from (f"only the page has {row}" for row in sorted(on_page - in_list, key=str))
    yield from (f"only the list has {row}" for row in sorted(in_list - on_page, key=str))


def compare_writer(profile, document):
    with h5py.File(profile, "r") as file:
        found = {f"{group}/{name}": d.attrs["units"].decode() if "units" in d.attrs else None
                 for group in file for name, d in file[group].items()}
        version = file.attrs["version"].tolist()
    expected = dataset_list.names_and_units(document["profile_version"])
    if version != document["profile_version"]:
        yield f"the writer writes version {version}, the list describes {document['profile_version']}"
    yield from (f"written, but not listed: {item}" for item in sorted(found.items() - expected.items(), key=str))
    yield from (f"listed, but not written: {item}" for item in sorted(expected.items() - found.items(), key=str))


def replace(file, path, values, dtype):
    """Puts `values` in the dataset's place; None removes it."""
    attributes = dict(file[path].attrs)
    del file[path]
    if values is None:
        return
    file.create_dataset(path, data=values, dtype=dtype, track_times=False)
    file[path].attrs.update(attributes)


def with_first(values, value):
    """A copy whose first element, or only value, is `value`."""
    changed = np.array(values)
    changed.flat[0] = value
    return changed


def text_damages(values, entry):
    yield "not UTF-8", with_first(values, b"\xff")
    if entry.get("is") == "name":
        yield "empty", with_first(values, b"")
    if entry.get("is") == "sha256":
        yield "upper case", with_first(values, b"A" * 64)


def number_damages(values, entry, row_counts):
    if entry["type"] == "real":
        yield "NaN", with_first(values, np.nan)
        yield "infinite", with_first(values, np.inf)
        yield "beyond 1e6", with_first(values, -1.1e6)
    if entry["type"] == "bool":
        yield "2", with_first(values, 2)
    if "minimum" in entry:
        below = entry["minimum"] - 1 if entry["type"] == "int" else entry["minimum"] - 1e-7
        yield "below the minimum", with_first(values, below)
    if "maximum" in entry:
        above = entry["maximum"] + 1 if entry["type"] == "int" else entry["maximum"] + 1e-7
        yield "above the maximum", with_first(values, above)
    if "index_of" in entry:
        yield "no row", with_first(values, row_counts[entry["index_of"]])
        yield "negative", with_first(values, -2 if entry.get("or_none") else -1)
    if entry.get("is") == "unit_vector":
        yield "too long", values * (1 + 2e-6)
    if entry.get("is") == "rigid_transform":
        yield "mirrored", values * np.diag([1, 1, -1, 1])
        yield "not homogeneous", values * np.array([1, 1, 1, 2]).reshape(4, 1)
    if entry.get("is") == "azimuth":
        yield "-pi", with_first(values, -np.pi)
    if entry.get("is") == "polar_angle":
        yield "beyond pi", with_first(values, np.pi + 1e-9)


def value_damages(values, entry, row_counts):
    """(label, values) that break a rule of the list."""
    if entry["type"] == "text":
        yield from text_damages(values, entry)
    else:
        yield from number_damages(values, entry, row_counts)


def layout_damages(values, entry):
    """(label, values, type) of another layout; None removes the dataset."""
    yield "missing", None, None
    if entry["type"] == "text":
        yield "numbers", np.zeros(values.shape, "<i4"), None
    else:
        yield "another type", values, {"real": "<f4", "int": "<i8", "bool": "<i4"}[entry["type"]]
    yield "one dimension more", np.expand_dims(values, -1), None
    fixed = [extent for extent in entry["shape"] if isinstance(extent, int)]
    if fixed:
        yield "one column more", np.concatenate([values, values[..., :1]], axis=-1), None


def damages(profile, entries):
    """(label, path, function of an open file that does the damage)."""
    with h5py.File(profile, "r") as file:
        first = {entry["path"].split("/")[0]: entry["path"] for entry in reversed(entries)}
        row_counts = {entry["index_of"]: len(file[first[entry["index_of"]]]) for entry in entries if "index_of" in entry}
        for entry in entries:
            path, values = entry["path"], file[entry["path"]][()]
            changes = [*layout_damages(values, entry),
                       *((label, changed, None) for label, changed in value_damages(np.asarray(values), entry, row_counts))]
            for label, changed, dtype in changes:
                yield label, path, functools.partial(replace, path=path, values=changed, dtype=dtype)


def refused_by_tool(bin_folder, path):
    done = subprocess.run([bin_folder / "uhas-inspect", "--validate", path], capture_output=True, text=True)
    return done.stderr if done.returncode == 1 and not done.stdout else ""


def refused_by_second_reader(path):
    try:
        read_profile.load(path)
    except ValueError as refusal:
        return str(refusal)
    return ""


def check_readers(bin_folder, profile, entries, scratch):
    """Messages on damages that a reader lets pass or does not name, and the number of damages tried."""
    messages, count = [], 0
    damaged = scratch / "damaged.h5"
    for label, path, damage in damages(profile, entries):
        count += 1
        shutil.copy(profile, damaged)
        with h5py.File(damaged, "r+") as file:
            damage(file)
        read_profile.seal(damaged)
        answers = {"uhas-inspect": refused_by_tool(bin_folder, damaged), "the second reader": refused_by_second_reader(damaged)}
        messages += [f"{path}, {label}: {reader} says '{words.strip()}'" for reader, words in answers.items() if path not in words]
    return messages, count


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    parser.add_argument("--profile", required=True, type=pathlib.Path, help="a sound profile with a row in every dataset")
    options = parser.parse_args()

    document = dataset_list.load_list()
    with tempfile.TemporaryDirectory() as folder:
        messages, count = check_readers(options.bin, options.profile, document["datasets"], pathlib.Path(folder))
    messages += [*compare_page(document["datasets"]), *compare_writer(options.profile, document)]
    for message in messages:
        print(f"check_dataset_list.py: {message}", file=sys.stderr)
    print(f"{len(document['datasets'])} datasets, {count} damages, {len(messages)} differences")
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
