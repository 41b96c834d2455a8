#!/usr/bin/env python3
"""A header with its plain comments as Doxygen reads them: the comment at the top tells of the file, and in uhas.h, whose comments
are those of C, each tells of what it stands above or beside. `docs/page.md#heading` is no link to a member. Line numbers stay as
they are."""

import re
import sys


def of_cpp(text):
    """The `//` lines at the top become the file's description."""
    top = re.match(r"(//(?!/).*\n)+", text)
    if not top:
        return text
    return re.sub(r"^//", "///", top[0], flags=re.M).rstrip() + " @file\n" + text[top.end():]


def of_c(text):
    """Comments at the margin tell of what follows, those beside code of that code."""
    text = re.sub(r"\A/\* (.*?)\*/", r"/** \1@file */", text, flags=re.S)
    text = re.sub(r"^/\* (?!----)", "/** ", text, flags=re.M)
    text = re.sub(r"^(typedef (?:struct|enum) \w+ \{) /\* (.*) \*/$", r"/** \2 */ \1", text, flags=re.M)
    return re.sub(r"^( +\S.*|[a-z].*;) +/\* (.*) \*/$", r"\1 /**< \2 */", text, flags=re.M)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r"(docs/[\w-]+\.md)#", r"\1\#", text)
    sys.stdout.write(of_c(text) if sys.argv[1].endswith(".h") else of_cpp(text))


if __name__ == "__main__":
    main()
