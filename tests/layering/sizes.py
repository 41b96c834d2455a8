#!/usr/bin/env python3
"""Checks that nothing in lib and tools has grown too large to be taken in at once: a folder of 25 files, a function of 60
lines, a class of 200. One that is larger says why, in a comment above it with the words `in one piece`.

    sizes.py SOURCE_FOLDER      exit 1 when something is larger without a reason
    sizes.py --self-test        exit 1 when one of the sizes planted here is judged wrongly

Functions and classes are told by the layout that clang-format gives them: they end with the first closing brace that stands as far
out as the line on which they begin.
"""

import pathlib
import re
import sys

from planted import self_test

MOST_FILES, MOST_FUNCTION_LINES, MOST_CLASS_LINES = 25, 60, 200
SOURCES = {".hpp", ".cpp", ".h", ".c"}
REASON = "in one piece"

CLASS = re.compile(r"\s*(?:class|struct|enum class)\b[^;()]*\{$")
NO_FUNCTION = re.compile(r"\s*(?:\}|namespace\b|extern\b|#|using\b|typedef\b|if\b|for\b|while\b|switch\b|else\b|do\b|try\b|case\b|default\b)")

LAMBDA = re.compile(r"\[[&=\w, ]*\]\s*[({]")  # counts to the function around it


def blocks(lines):
    """First and last line of each class and function, counted from 0, with its kind."""
    for first, line in enumerate(lines):
        if not line.endswith("{") or NO_FUNCTION.match(line) or LAMBDA.search(line):
            continue
        # a head that is broken over lines begins at the last line that is not deeper
        head = first
        while head > 0 and re.match(r"\s*[:(]|\s{4,}\S", lines[head]) and lines[head - 1].strip() and not lines[head - 1].endswith((";", "}", "{")):
            head -= 1
        indent = re.match(r"\s*", lines[head])[0]
        kind = "class" if CLASS.match(line) else "function" if "(" in "".join(lines[head:first + 1]) else None
        last = next((n for n in range(first + 1, len(lines)) if re.match(indent + r"\}[;,)]*( .*)?$", lines[n])), None)
        if kind and last is not None:
            yield kind, head, last


def has_reason(lines, head):
    """Whether the comment right above, over a template's head if there is one, gives a reason."""
    n = head - 1
    while n >= 0 and re.match(r"\s*(//|\*|/\*|template\b)", lines[n]):
        if REASON in lines[n].lower():
            return True
        n -= 1
    return False


def problems_of_text(text):
    lines = text.split("\n")
    for kind, first, last in blocks(lines):
        length, most = last - first + 1, MOST_CLASS_LINES if kind == "class" else MOST_FUNCTION_LINES
        if length > most and not has_reason(lines, first):
            yield f"{first + 1}: a {kind} of {length} lines, over {most}, without a reason"


def problems(root):
    for place in ("lib", "tools"):
        for folder in sorted({path.parent for path in (root / place).rglob("*")}):
            files = [path for path in folder.iterdir() if path.is_file()]
            if len(files) > MOST_FILES:
                yield f"{folder.relative_to(root)}: {len(files)} files, over {MOST_FILES}"
        for path in sorted((root / place).rglob("*")):
            if path.suffix in SOURCES:
                for problem in problems_of_text(path.read_text(encoding="utf-8")):
                    yield f"{path.relative_to(root)}:{problem}"


def body(count):
    return "  f();\n" * count


# text, whether it is too large
PLANTED = [
    ("void f() {\n" + body(58) + "}\n", False),
    ("void f() {\n" + body(59) + "}\n", True),
    ("/// In order; in one piece, since it is a table.\nvoid f() {\n" + body(59) + "}\n", False),
    ("template <class T>\nvoid f(int a,\n       int b) noexcept {\n" + body(58) + "}\n", True),
    ("class C {\n  void g() {\n" + body(30) + "  }\n" + body(166) + "};\n", False),
    ("class C {\n" + body(199) + "};\n", True),
    ("struct S {\n  void g() {\n    if (a) {\n" + body(60) + "    }\n  }\n};\n", True),
    ("namespace uhas {\n" + body(300) + "}  // namespace uhas\n", False),
]


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test(PLANTED, lambda text: list(problems_of_text(text)))
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    found = list(problems(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "nothing is too large")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
