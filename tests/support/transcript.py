"""Commands in documents, run as a reader would, and what they print against what the document shows."""

import math
import re
import subprocess

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def same(shown, printed):
    """Whether two lines are equal, numbers as far as they are on every machine: to 1e-6, and to 1e-9 near zero."""
    shown, printed = shown.strip(), printed.strip()
    if NUMBER.split(shown) != NUMBER.split(printed):
        return False
    pairs = zip(map(float, NUMBER.findall(shown)), map(float, NUMBER.findall(printed)))
    return all(math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-9) for a, b in pairs)


def shows(shown, printed):
    """Whether `printed` is `shown`, in which a line `...` stands for any number of lines."""
    lines, position, gap = printed.splitlines(), 0, False
    for text in shown.splitlines():
        if text.strip() == "...":
            gap = True
            continue
        while gap and position < len(lines) and not same(text, lines[position]):
            position += 1
        if position == len(lines) or not same(text, lines[position]):
            return False
        position, gap = position + 1, False
    return gap or position == len(lines)


def talk(stderr):
    """Lines of stderr that a success must not leave: all but warnings."""
    return [line for line in stderr.splitlines() if ": warning: " not in line]


def run(command, shown, folder, environment):
    """Faults of one command: it must succeed, leave stderr empty but for warnings, and print `shown` where that is not empty."""
    done = subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True)
    if done.returncode != 0 or talk(done.stderr):
        return [f"'{command}' exits with {done.returncode}: {done.stderr.strip()}"]
    if shown and not shows(shown, done.stdout):
        return [f"'{command}' does not print\n{shown}but\n{done.stdout}"]
    return []
