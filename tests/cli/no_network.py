#!/usr/bin/env python3
"""No tool speaks to the network, nor does any library that it is made of: each runs on real work under strace, which must see no
call of the network's. The HDF5 library of Debian, for one, is linked with libcurl.

    no_network.py --bin build/dev/bin
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import real_work

NETWORK_URDF = """<robot name="hand"><link name="finger"/><link name="palm"><visual><geometry>
<mesh filename="http://localhost:9/palm.stl"/></geometry></visual></link><joint name="knuckle" type="revolute"><parent link="palm"/>
<child link="finger"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>"""


def traced(command, environment):
    """The command's exit code and the calls of the network's that it and its children made."""
    with tempfile.NamedTemporaryFile() as log:
        done = subprocess.run(["strace", "-f", "-qq", "-e", "signal=none", "-e", "trace=%network", "-o", log.name, *command],
                              env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, timeout=300)
        return done.returncode, pathlib.Path(log.name).read_text()


def can_trace():
    return shutil.which("strace") and subprocess.run(["strace", "-o", os.devnull, "true"], capture_output=True).returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path, help="folder of the built tools")
    bin_folder = parser.parse_args().bin.resolve()
    if not can_trace():
        print("SKIPPED: calls of the network: strace is not installed, or tracing is not permitted here")
        return 0
    environment = dict(os.environ, PATH=f"{bin_folder}{os.pathsep}{os.environ['PATH']}", LC_ALL="C")

    _, calls = traced([sys.executable, "-c", "import socket; socket.socket()"], environment)
    faults = [] if "socket(AF_INET" in calls else [f"a socket goes unnoticed: {calls}"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        real_work.write_input(folder)
        (folder / "network.urdf").write_text(NETWORK_URDF)
        tried = [(command, 0) for command in real_work.commands(folder)]
        tried.append((["uhas-build-profile", str(folder / "network.urdf")], 1))
        for command, expected_code in tried:
            code, calls = traced(command, environment)
            if code != expected_code or calls:
                faults.append(f"{' '.join(command)}: exit code {code}, {calls or 'no calls'}")
    untried = {path.name for path in bin_folder.glob("uhas-*")} - {command[0] for command, _ in tried}
    faults += [f"{tool} is not tried" for tool in sorted(untried)]
    print("\n".join(faults) or f"{len(tried)} runs, no call of the network's")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
