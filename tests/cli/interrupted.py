#!/usr/bin/env python3
"""Builds of a profile that are killed, doubled, or find no room: the old file stays whole or there is none, and nothing is in
the way of the next build.

    interrupted.py --bin build/dev/bin
"""
import argparse
import contextlib
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
URDF = HERE.parent.parent / "hands" / "allegro_right" / "allegro_right.urdf"
KILLS = 50


def build(folder, *arguments, **popen):
    return subprocess.Popen(["uhas-build-profile", "--quiet", URDF, "-o", "hand.h5", *arguments], cwd=folder,
                            stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, **popen)


def finish(process):
    """(exit code, stderr)"""
    _, stderr = process.communicate(timeout=120)
    return process.returncode, stderr


def names(folder):
    return sorted(entry.name for entry in folder.iterdir())


def killed_at_random_moments(folder, good):
    """kill -9 at moments spread over a build, on an old file and on none."""
    start = time.monotonic()
    assert finish(build(folder)) == (0, "")
    duration = time.monotonic() - start
    (folder / "hand.h5").unlink()
    seed = 1
    moments = random.Random(seed)
    killed = tried = 0
    while killed < KILLS:
        tried += 1
        assert tried < 10 * KILLS, f"only {killed} of {tried} builds were still running when they were killed"
        old = b"uhas-hand-profile, an old one" if tried % 2 else None
        if old:
            (folder / "hand.h5").write_bytes(old)
        process = build(folder)
        time.sleep(moments.uniform(0, duration))
        process.send_signal(signal.SIGKILL)
        if finish(process)[0] == -signal.SIGKILL:
            killed += 1
        else:
            duration *= 0.95  # builds have become faster, as on a machine that others have left
        found = (folder / "hand.h5").read_bytes() if (folder / "hand.h5").exists() else None
        assert found in (old, good), f"kill {tried} of seed {seed}: a file that is neither the old nor the new one"
        (folder / "hand.h5").unlink(missing_ok=True)
    assert finish(build(folder)) == (0, "") and (folder / "hand.h5").read_bytes() == good
    print(f"ok      kill -9 at {KILLS} moments of a build")


def two_at_once(folder, good):
    for _ in range(5):
        both = [build(folder), build(folder)]
        assert [finish(process) for process in both] == [(0, ""), (0, "")]
        assert (folder / "hand.h5").read_bytes() == good
        assert names(folder) == ["hand.h5"], names(folder)
    print("ok      two builds to one path at once")


def interrupted_writes(folder, good):
    """Every file is cut off at 100 kB, as on a disk that fills up; SIGXFSZ is ignored so that the write fails."""
    import resource

    def bound():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))

    (folder / "hand.h5").write_bytes(b"uhas-hand-profile, an old one")
    code, stderr = finish(build(folder, preexec_fn=bound))
    assert code == 1 and stderr == ("uhas-build-profile: error: hand.h5: cannot be written: File too large; "
                                    "check the folder, its permissions and the free space\n"), (code, stderr)
    assert (folder / "hand.h5").read_bytes() == b"uhas-hand-profile, an old one" and names(folder) == ["hand.h5"]
    print("ok      a write that fails half way")


@contextlib.contextmanager
def mounted(folder, options):
    """A file system in memory; yields False where none can be mounted."""
    done = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", folder], capture_output=True)
    try:
        yield done.returncode == 0
    finally:
        if done.returncode == 0:
            subprocess.run(["umount", folder], check=True)


def full_disk(folder, good):
    with mounted(folder, "size=128k") as is_mounted:
        if not is_mounted:
            print("SKIPPED: full disk: no file system can be mounted here")
            return
        (folder / "hand.h5").write_bytes(b"uhas-hand-profile, an old one")
        code, stderr = finish(build(folder))
        assert code == 1 and stderr == ("uhas-build-profile: error: hand.h5: cannot be written: No space left on device; "
                                        "check the folder, its permissions and the free space\n"), (code, stderr)
        assert (folder / "hand.h5").read_bytes() == b"uhas-hand-profile, an old one" and names(folder) == ["hand.h5"]
    print("ok      a full disk")


def read_only_folder(folder, good):
    with mounted(folder, "size=1m") as is_mounted:
        if not is_mounted or subprocess.run(["mount", "-o", "remount,ro", folder], capture_output=True).returncode != 0:
            print("SKIPPED: read-only folder: no file system can be mounted here")
            return
        code, stderr = finish(build(folder))
        assert code == 1 and stderr == ("uhas-build-profile: error: hand.h5: no file can be made in its folder: Read-only file "
                                        "system; check the folder, its permissions and the free space\n"), (code, stderr)
        assert names(folder) == []
    print("ok      a read-only folder")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    os.environ["PATH"] = f"{parser.parse_args().bin.resolve()}{os.pathsep}{os.environ['PATH']}"
    os.environ["LC_ALL"] = "C"

    with tempfile.TemporaryDirectory() as scratch:
        reference = pathlib.Path(scratch, "reference")
        reference.mkdir()
        assert finish(build(reference)) == (0, "")
        good = (reference / "hand.h5").read_bytes()
        for check in (killed_at_random_moments, two_at_once, interrupted_writes, full_disk, read_only_folder):
            folder = pathlib.Path(scratch, check.__name__)
            folder.mkdir()
            check(folder, good)
    return 0


if __name__ == "__main__":
    sys.exit(main())
