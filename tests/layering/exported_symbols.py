#!/usr/bin/env python3
"""Checks that the shared libraries show what is documented and nothing else, and take nothing of their own from a program.

    exported_symbols.py NM READELF LIBRARY...             each after those that it is linked with
    exported_symbols.py --refresh NM READELF LIBRARY...   writes what they show to exported/<library>.txt
    exported_symbols.py --self-test                       exit 1 when a symbol that must not be shown goes unnoticed

What a library shows is the list on file, in short names: std::string, std::span<double>. All of it is declared in an installed
header, and all that is marked there is shown. A symbol that a program might have too, having been compiled otherwise, would be taken
from the program by the dynamic linker; so none of the library's own is looked up by name, but for the types of its exceptions.
"""

import pathlib
import re
import subprocess
import sys

from planted import self_test

HERE = pathlib.Path(__file__).resolve().parent
LIB = HERE.parents[1] / "lib"
TYPE_OF_CLASS = re.compile(r"(?:vtable|typeinfo|typeinfo name) for uhas::(\w+)$")
MEMBER = re.compile(r"uhas::(\w+)(?:<(?:float|double)>)?::(?:~?\w+|operator=)\(")  # not of a class in the class
FUNCTION = re.compile(r"uhas::(\w+)\(|(uhas_\w+)$")
SHORT = [(r"\[abi:cxx11\]", ""),
         (r"std::__cxx11::basic_string<char, std::char_traits<char>, std::allocator<char> >", "std::string"),
         (r"(std::vector<([\w:]+)), std::allocator<\2 > ?>", r"\1>"), (r", 18446744073709551615ul>", ">"), (r" >", ">")]


def short(symbol):
    for pattern, text in SHORT:
        symbol = re.sub(pattern, text, symbol)
    return symbol


def documented(headers):
    """What installed headers mark: (classes, functions, class templates that are compiled in the library)."""
    cpp = "\n".join(text for name, text in headers.items() if name.endswith(".hpp"))
    c = "\n".join(re.sub(r"/\*.*?\*/", "", text, flags=re.S) for name, text in headers.items() if name.endswith(".h"))
    return (set(re.findall(r"\bclass UHAS_API (\w+)", cpp)),
            set(re.findall(r"^UHAS_API [^;(]*?(\w+)\(", cpp, re.M)) | set(re.findall(r"^[a-z][^;(]*?\b(uhas_\w+)\(", c, re.M)),
            set(re.findall(r"^extern template class (\w+)<", cpp, re.M)))


def fault(kind, symbol, declared):
    """What is wrong with showing this symbol, or None. `kind` is nm's letter."""
    classes, functions, templates = declared
    member, function, of_type = MEMBER.match(symbol), FUNCTION.match(symbol), TYPE_OF_CLASS.match(symbol)
    if of_type:
        return None if of_type[1] in classes else "the type of a class that no installed header marks"
    if not (member and member[1] in classes) and not (function and (function[1] or function[2]) in functions):
        return "no installed header declares it"
    if kind != "T" and not (member and member[1] in templates):
        return "inline: the dynamic linker might take it from a program"
    return None


def missing(symbols, declared):
    """Marked classes and functions without a symbol."""
    matches = [pattern.match(symbol) for symbol in symbols for pattern in (MEMBER, FUNCTION)]
    there = {name for match in matches if match for name in match.groups()}
    return sorted((declared[0] | declared[1]) - there)


def lines_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


class Library:
    def __init__(self, nm, readelf, path):
        self.name = re.match(r"\w+", pathlib.Path(path).name)[0]
        self.list = HERE / "exported" / f"{self.name}.txt"
        defined = [line.split()[1:] for line in lines_of(nm, "-D", "--defined-only", "--no-sort", path)]
        readable = lines_of(nm, "-D", "--defined-only", "--no-sort", "--demangle", path)
        self.kinds = {short(line.split(maxsplit=2)[2]): kind for (kind, _), line in zip(defined, readable, strict=True)}
        self.mangled = {name for _, name in defined}
        self.lacks = {line.split()[1] for line in lines_of(nm, "-D", "--undefined-only", path) if re.search(r" _ZT?.?N?K?4uhas", line)}
        looked_up = {line.split()[4] for line in lines_of(readelf, "--relocs", "--wide", path) if re.match(r"[0-9a-f]{16} ", line)
                     and len(line.split()) > 4}
        self.looks_up = {name for name in looked_up & self.mangled if not name.startswith("_ZT")}

    def faults(self, declared):
        yield from (f"{symbol}: {what}" for symbol, kind in self.kinds.items() if (what := fault(kind, symbol, declared)))
        yield from (f"{name}: looked up by name, a program's might be taken" for name in sorted(self.looks_up))
        listed = set(self.list.read_text().splitlines()) if self.list.exists() else set()
        yield from (f"{symbol}: not on the list" for symbol in sorted(self.kinds.keys() - listed))
        yield from (f"{symbol}: on the list, but not shown" for symbol in sorted(listed - self.kinds.keys()))


PLANTED_HEADERS = {"cascade_solver.hpp": "class UHAS_API Solver {\nextern template class Solver<float>;\nclass UHAS_API Error {\n"
                                         "UHAS_API HandProfile read_profile(const std::string& path);\nvoid helper(int);\n",
                   "uhas.h": "int uhas_version(void); /* not uhas_reset(void) */\n"}
PLANTED = [
    (("T", "uhas::read_profile(std::string const&)"), False),
    (("T", "uhas_version"), False),
    (("T", "uhas::Error::~Error()"), False),
    (("V", "typeinfo for uhas::Error"), False),
    (("W", "uhas::Solver<float>::solve(uhas::Action<float> const&)"), False),
    (("W", "uhas::Solver<float>::operator=(uhas::Solver<float>&&)"), False),
    (("W", "uhas::Solver<float>::Scratch::resize()"), True),
    (("W", "uhas::Error::code() const"), True),
    (("W", "uhas::read_profile(std::string const&)"), True),
    (("T", "uhas::helper(int)"), True),
    (("T", "uhas_reset"), True),
    (("V", "typeinfo for uhas::Motion"), True),
    (("u", "uhas::counter()::count"), True),
    (("W", "std::vector<double>::push_back(double const&)"), True),
]


def main():
    arguments = sys.argv[1:]
    if arguments == ["--self-test"]:
        return self_test(PLANTED, lambda sample: fault(*sample, documented(PLANTED_HEADERS)))
    refresh = arguments[:1] == ["--refresh"]
    if len(arguments) < 3 + refresh:
        print(__doc__, file=sys.stderr)
        return 2
    nm, readelf, *paths = arguments[refresh:]
    libraries = [Library(nm, readelf, path) for path in paths]
    if refresh:
        for library in libraries:
            library.list.write_text("".join(f"{symbol}\n" for symbol in sorted(library.kinds)))
    installed = [line.split()[1] for line in (LIB / "public_headers.txt").read_text().splitlines()]
    declared = documented({name: (LIB / "uhas" / name).read_text() for name in installed})
    found, shown = [], {}
    for library in libraries:
        found += [f"{library.name}: {fault}" for fault in library.faults(declared)]
        found += [f"{library.name}: {name}: shown by no library that it is linked with" for name in sorted(library.lacks - shown.keys())]
        found += [f"{library.name}: {symbol}: shown by {shown[symbol]} too" for symbol in sorted(library.mangled & shown.keys())]
        shown |= dict.fromkeys(library.mangled, library.name)
    every = [symbol for library in libraries for symbol in library.kinds]
    found += [f"{name}: marked in an installed header, but shown by no library" for name in missing(every, declared)]
    print("\n".join(found) or f"{len(libraries)} libraries, {len(every)} symbols, all of them documented")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
