#!/usr/bin/env python3
"""Checks that no code of ours calls the network: no tool and no library imports a function that opens or uses a socket.

    network_symbols.py NM FILE...      exit 1 when a library or an executable imports such a function
    network_symbols.py --self-test     exit 1 when such an import goes unnoticed
"""

import re
import subprocess
import sys

from planted import self_test

NETWORK = re.compile(r"(socket|socketpair|connect|bind|listen|accept4?|shutdown|[gs]etsockopt|getsockname|getpeername"
                     r"|(send|recv)(to|from|m?msg)?|getaddrinfo|getnameinfo|(gethost|getserv|getproto|getnet)(by\w+|ent\w*)"
                     r"|__res_\w+|res_\w+|curl_\w+)$")


def network_imports(listing):
    """Functions of the network among the undefined symbols that nm lists: `U connect@GLIBC_2.2.5`."""
    symbols = re.findall(r"^\s+[Uw] (\w+)", listing, re.M)
    return sorted({symbol for symbol in symbols if NETWORK.match(symbol)})


PLANTED = [
    ("                 U socket@GLIBC_2.2.5", True),
    ("                 U getaddrinfo@GLIBC_2.2.5", True),
    ("                 U recvmsg@GLIBC_2.2.5", True),
    ("                 w curl_easy_init", True),
    ("                 U accept4@GLIBC_2.10", True),
    ("                 U pipe2@GLIBC_2.9", False),
    ("                 U sendfile64@GLIBC_2.3", False),
    ("                 U _ZN4uhas7connectEv", False),
    ("0000000000000010 T connect", False),
]


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test(PLANTED, network_imports)
    if len(sys.argv) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    faults = []
    for path in sys.argv[2:]:
        listing = subprocess.run([sys.argv[1], "--dynamic", "--undefined-only", path], check=True, capture_output=True,
                                 text=True).stdout
        if not listing:
            faults.append(f"{path} imports nothing at all")
        faults += [f"{path} imports {symbol}" for symbol in network_imports(listing)]
    print("\n".join(faults) or f"{len(sys.argv) - 2} files, none of which imports the network")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
