#!/usr/bin/env python3
"""A stream of actions without end through `uhas-solve -`: every line has its answer, in order, and errors are where they must
be; solutions are finite and within limits, and the same for the same action however long ago; memory and open files do not grow.

    stream.py --bin build/dev/bin                      a few seconds
    stream.py --bin build/dev/bin --seconds 3600       the long form
"""
import argparse
import collections
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

HAND = pathlib.Path(__file__).resolve().parent.parent.parent / "hands" / "allegro_right" / "allegro_right.urdf"
CHUNK = 50          # lines whose answers fit into a pipe, so that neither side waits for the other
GROWTH_KB = 256     # of memory: what an allocator may round up; a byte lost a line is more within a minute
FOLLOWER_SLACK = 1e-9

ZEROS = b"[" + b"0, " * 14 + b"0]"
# (line, how its error begins)
BAD_LINES = [
    (ZEROS.replace(b"0", b"NaN", 1), "not JSON"),
    (ZEROS.replace(b"0", b"-Infinity", 1), "not JSON"),
    (ZEROS.replace(b"0", b"1e999", 1), "number overflow"),
    (ZEROS.replace(b"0", b'"0"', 1), 'action: element 0 is "0"; write a number'),
    (ZEROS.replace(b"0", b"null", 1), "action: element 0 is null; write a number"),
    (ZEROS.replace(b"0, ", b"", 1), "action: has 14 numbers"),
    (b"[" + b"0, " * 4999 + b"0]", "action: has 5000 numbers"),
    (b"[]", "action: has 0 numbers"),
    (ZEROS + ZEROS, "not JSON"),
    (ZEROS[:-1], "not JSON"),
    (b"{", "not JSON"),
    (b"\0", "not JSON"),
    (b"null", "action: is null"),
    (b'"' + b"a" * 5000 + b'"', 'action: is "aaaa'),
    (b'{"lateral": [0, 0, 0, 0, 0]}', "action: lateral or radial is missing"),
    (b'{"lateral": 7, "radial": [[0], [0], [0], [0], [0]]}', "action: lateral is not an array"),
    (b'{"lateral": [0, 0, 0, 0, 0], "radial": [[0], [0], [0], [0], [0, 0]]}', "action: the planes of radial differ"),
    (b'{"lateral": [], "radial": [], "third": 0}', 'action: unknown key "third"'),
    (b'"\xc3"', "not JSON"),
    (b"\xff\xfe" + ZEROS, "not JSON"),
    (b'{"\xf0\x9f\x96": 0}', "not JSON"),
    (b"[" * 1000, "nested more than 8 levels deep"),
]
TOO_LONG = (b"[" + b" " * (1 << 20) + b"]", "the line is longer than 1 MiB")


def action_line(draw):
    """An action as a policy may put it out, of any number of driving vectors, as an array or an object."""
    vectors = draw.randint(1, 4)
    size = 10.0 ** draw.randint(-300, 300) if draw.random() < 0.05 else draw.choice((0.1, 0.6, 3.0))
    numbers = [size * draw.uniform(-1, 1) for _ in range(5 + 5 * vectors)]
    if draw.random() < 0.7:
        return json.dumps(numbers).encode()
    radial = [numbers[5 + vectors * slot:5 + vectors * (slot + 1)] for slot in range(5)]
    return json.dumps({"lateral": numbers[:5], "radial": radial}).encode()


def refuse_constant(name):
    raise ValueError(f"{name} is not JSON")


class Stream:
    """The tool at work, and what it must answer."""

    def __init__(self, bin_dir, profile, seed):
        summary = json.loads(subprocess.run([bin_dir / "uhas-inspect", profile, "--json"], check=True,
                                            capture_output=True).stdout)
        joints = {joint["name"]: joint for finger in summary["fingers"] for joint in finger["joints"]}
        self.limits = []
        for name in summary["joint_names"]:
            slack = FOLLOWER_SLACK if joints[name]["mimic"] else 0
            self.limits.append((joints[name]["lower"] - slack, joints[name]["upper"] + slack))
        self.names = set(joints)
        self.draw = random.Random(seed)
        self.probes = {action_line(self.draw): None for _ in range(20)}  # sent again and again; their first answers
        self.counts = collections.Counter()
        self.sent = 0
        self.tool = subprocess.Popen([bin_dir / "uhas-solve", "-", "--profile", profile], stdin=subprocess.PIPE,
                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def draw_line(self):
        """(line, how the answer's error begins, None for a solution)"""
        kind = self.draw.random()
        if kind < 0.0002:
            return TOO_LONG
        if kind < 0.05:
            return self.draw.choice(BAD_LINES)
        if kind < 0.1:
            return self.draw.choice(list(self.probes)), None
        return action_line(self.draw), None

    def exchange(self, lines):
        """Sends the lines and a blank one, which asks nothing; reads and checks their answers."""
        self.tool.stdin.write(b"".join(line + b"\n" for line, _ in lines) + b" \n")
        self.tool.stdin.flush()
        for line, error in lines:
            self.sent += 1
            answer = self.tool.stdout.readline()
            try:
                self.check(line, error, answer)
            except (AssertionError, ValueError, KeyError) as problem:
                sys.exit(f"line {self.sent}: {line[:400]!r}\n  answer {answer[:400]!r}\n  {type(problem).__name__}: {problem}")
        self.sent += 1

    def check(self, line, error, answer):
        document = json.loads(answer, parse_constant=refuse_constant)
        if error is not None:
            self.counts["errors"] += 1
            assert document.keys() == {"error", "line"} and document["line"] == self.sent, "not the error of this line"
            assert document["error"].startswith(error), f"not the error: {error}"
            return
        self.counts["solutions"] += 1
        assert len(document["q"]) == len(self.limits), "wrong number of joints"
        for value, (lower, upper) in zip(document["q"], self.limits):
            assert lower <= value <= upper, f"{value} is outside {lower} to {upper}"
        residual = document["residual_rms"]
        assert residual is None or residual >= 0, f"residual {residual}"
        assert self.names.issuperset(document["at_limit"] + document["closed"]), "unknown joints"
        if line in self.probes:
            self.counts["the same again"] += self.probes[line] is not None
            self.probes[line] = self.probes[line] or answer
            assert answer == self.probes[line], f"was answered {self.probes[line]!r} before"

    def usage(self):
        """Memory in kB, and open files."""
        status = pathlib.Path(f"/proc/{self.tool.pid}/status").read_text()
        lines = dict(line.split(":", 1) for line in status.splitlines())
        memory = {name: int(lines[name].split()[0]) for name in ("VmRSS", "VmHWM", "VmData")}
        return memory | {"files": len(list(pathlib.Path(f"/proc/{self.tool.pid}/fd").iterdir()))}

    def finish(self):
        """The tool ends by itself, counts what it could not solve, and says nothing else."""
        self.tool.stdin.close()
        assert self.tool.stdout.read() == b"", "answers that nobody asked for"
        stderr = self.tool.stderr.read().decode()
        assert self.tool.wait(timeout=60) == 1, f"exit code {self.tool.returncode}"
        assert stderr.startswith(f"uhas-solve: error: standard input: {self.counts['errors']} of the lines"), stderr


def run(stream, seconds):
    """Warms the tool up by every kind of line, then watches it."""
    stream.exchange([(probe, None) for probe in stream.probes])
    stream.exchange([*BAD_LINES, TOO_LONG])
    for _ in range(40):
        stream.exchange([stream.draw_line() for _ in range(CHUNK)])
    first = last = stream.usage()
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for _ in range(20):
            stream.exchange([stream.draw_line() for _ in range(CHUNK)])
        last = stream.usage()
        assert last["files"] == first["files"], f"{last['files']} open files, {first['files']} at the beginning"
        for kind in ("VmHWM", "VmData"):
            assert last[kind] <= first[kind] + GROWTH_KB, f"{kind} grew from {first[kind]} to {last[kind]} kB"
    return first, last


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    parser.add_argument("--seconds", type=float, default=3, help="how long to send lines [%(default)g]")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        profile = pathlib.Path(scratch) / "hand.h5"
        subprocess.run([options.bin / "uhas-build-profile", "--quiet", HAND, "-o", profile], check=True)
        stream = Stream(options.bin.resolve(), profile, options.seed)
        first, last = run(stream, options.seconds)
        stream.finish()
    print(f"seed {options.seed}, {options.seconds:g} s: {stream.sent} lines,",
          ", ".join(f"{count} {kind}" for kind, count in stream.counts.items()))
    for kind in first:
        print(f"  {kind}: {first[kind]} -> {last[kind]}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
