#!/usr/bin/env python3
"""Checks that no code compiled for AVX2 or AVX-512 can be linked into callers that run without it.

    kernel_symbols.py NM OBJECT...   exit 1 when an object whose name ends in _avx2 or _avx512 defines a weak symbol, which the
                                     linker may give to any caller, or a global one without avx in its name
    kernel_symbols.py --self-test    exit 1 when such a symbol goes unnoticed
"""

import pathlib
import re
import subprocess
import sys

from planted import self_test

# types of symbols that nm prints: what the object defines for others to see
SHARED = re.compile(r"^[0-9a-f]+ ([TDBRVWu]) (.+)$")


def leaks(listing):
    """The symbols in the output of nm that other objects may get without asking for its instructions."""
    found = []
    for line in listing.splitlines():
        match = SHARED.match(line)
        if match and (match[1] in "VWu" or "avx" not in match[2]):
            found.append(match[2])
    return found


PLANTED = [
    ("0000000000000000 T _ZN4uhas11kernel_avx2Ev", False),
    ("0000000000000040 t _ZN4uhas6sincosIN12_GLOBAL__N_14HereEEEvv", False),
    ("                 U memcpy", False),
    ("0000000000000010 W _ZSt3minIfERKT_S2_S2_", True),
    ("0000000000000010 V _ZTI4Some", True),
    ("0000000000000010 W _ZN4uhas5solve_avx2IfEvv", True),
    ("0000000000000020 T _ZN4uhas6kernelEv", True),
]


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test(PLANTED, leaks)
    if len(sys.argv) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    objects = [path for path in sys.argv[2:] if re.search(r"_avx(2|512)\.", pathlib.Path(path).name)]
    found = []
    for path in objects:
        listing = subprocess.run([sys.argv[1], path], check=True, capture_output=True, text=True).stdout
        found += [f"{pathlib.Path(path).name}: {symbol}" for symbol in leaks(listing)]
    print("\n".join(found) or f"{len(objects)} objects, no symbol to leak")
    return 0 if objects and not found else 1


if __name__ == "__main__":
    sys.exit(main())
