#!/usr/bin/env python3
"""Files of every version of the hand profile format: the good are read, the bad are refused word by word.

    check_golden.py --bin build/dev/bin [--refresh]

- no golden file has changed (SHA256SUMS), and each is in the list;
- good/: `uhas-inspect --validate` and the second reader (tests/crosscheck) read each, with exit code 0 and an empty stderr; what
  the tools say of the hands among them is what the second reader computes;
- a good file has the datasets that its version has by schemas/hand-profile-v1.datasets.json and no other, and the list's own
  version has good/full-<version>.h5, with a row in every dataset: a changed layout needs a new version and new files;
- bad/: uhas-inspect refuses each with exit code 1, an empty stdout and the line of refusals.txt; the second reader refuses each.

--refresh writes refusals.txt; read the difference before you commit it.
"""

import argparse
import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile

import h5py

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "crosscheck"))
import compare_tools  # noqa: E402
import dataset_list  # noqa: E402
import read_profile  # noqa: E402

REFUSALS = HERE / "refusals.txt"
NEWER = "newer_minor"  # newer than the version of the list at its time, whose datasets it has, and others


def golden_files(folder):
    return sorted((HERE / folder).glob("*.h5"))


def check_sums():
    sums = {name: digest for digest, name in (line.split() for line in (HERE / "SHA256SUMS").read_text().splitlines())}
    found = {str(path.relative_to(HERE)): hashlib.sha256(path.read_bytes()).hexdigest()
             for folder in ("good", "bad") for path in golden_files(folder)}
    for name in sorted(sums.keys() | found.keys()):
        if sums.get(name) != found.get(name):
            yield f"{name}: has changed, is gone, or is not in SHA256SUMS"


def inspect(bin_folder, path, *options):
    return subprocess.run([bin_folder / "uhas-inspect", path.relative_to(HERE), *options], cwd=HERE, capture_output=True, text=True)


def stated_version(path):
    return [int(number) for number in path.stem.rpartition("-")[2].split(".")]


def check_layout(path, document):
    """Whether the file has the datasets of its version and, as the list's full file, a row in each."""
    with h5py.File(path, "r") as file:
        sizes = {f"{group}/{name}": dataset.size for group in file for name, dataset in file[group].items()}
    version = stated_version(path)
    expected = dataset_list.names_and_units(version).keys()
    for name in sorted(expected ^ sizes.keys()):
        yield f"{path.name}: {name} is in one of file and list only; a new layout needs a new version and new golden files"
    if path.stem.startswith("full-") and version == document["profile_version"]:
        yield from (f"{path.name}: {name} is empty" for name, size in sorted(sizes.items()) if size == 0)


def check_good(bin_folder, path, document):
    done = inspect(bin_folder, path, "--validate")
    if done.returncode != 0 or done.stderr:
        yield f"{path.name}: uhas-inspect --validate exits with {done.returncode}: {done.stderr.strip()}"
    if not path.stem.startswith(NEWER):
        yield from check_layout(path, document)
    try:
        profile = read_profile.load(path)
    except ValueError as refusal:
        yield f"{path.name}: the second reader says: {refusal}"
        return
    summary = json.loads(inspect(bin_folder, path, "--json", "--quiet").stdout)
    yield from (f"{path.name}: {message}" for message in compare_tools.compare_summary(profile, summary))
    with tempfile.TemporaryDirectory() as folder:
        yield from (f"{path.name}: {message}" for message in compare_solution(bin_folder, path, profile, pathlib.Path(folder)))


def compare_solution(bin_folder, path, profile, folder):
    """What uhas-solve makes of two actions against the second reader."""
    actions = {"format": "uhas-actions", "version": 1, "actions": [[0.0] * 15, [0.1] * 5 + [-0.2] * 10]}
    (folder / "actions.json").write_text(json.dumps(actions))
    done = subprocess.run([bin_folder / "uhas-solve", folder / "actions.json", "--profile", path], capture_output=True, text=True)
    yield from read_profile.compare_residuals(profile, json.loads(done.stdout), actions, compare_tools.TOLERANCE)


def refusal(bin_folder, path):
    """(line on stderr, messages)."""
    done = inspect(bin_folder, path)
    messages = []
    if done.returncode != 1 or done.stdout or done.stderr.count("\n") != 1:
        messages.append(f"{path.name}: exits with {done.returncode}, prints {len(done.stdout)} bytes and {done.stderr!r}")
    try:
        read_profile.load(path)
        messages.append(f"{path.name}: the second reader accepts it")
    except ValueError:
        pass
    return done.stderr, messages


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    parser.add_argument("--refresh", action="store_true", help="write refusals.txt instead of comparing")
    options = parser.parse_args()
    bin_folder = options.bin.resolve()

    document = dataset_list.load_list()
    messages = list(check_sums())
    full = HERE / "good" / ("full-" + ".".join(map(str, document["profile_version"])) + ".h5")
    if not full.exists():
        messages.append(f"{full.name} is missing: run make_golden.py for the new version")
    for path in golden_files("good"):
        if not path.stem.startswith(NEWER) or stated_version(path) == document["profile_version"]:
            messages += check_good(bin_folder, path, document)

    lines = []
    for path in golden_files("bad"):
        line, found = refusal(bin_folder, path)
        lines.append(line)
        messages += found
    if options.refresh:
        REFUSALS.write_text("".join(lines))
    expected = REFUSALS.read_text().splitlines(keepends=True)
    messages += [f"not said: {line.strip()}" for line in expected if line not in lines]
    messages += [f"not expected: {line.strip()}" for line in lines if line not in expected]
    for message in messages:
        print(f"check_golden.py: {message}", file=sys.stderr)
    print(f"{len(golden_files('good'))} good files, {len(lines)} bad ones, {len(messages)} differences")
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
