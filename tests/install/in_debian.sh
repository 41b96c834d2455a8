#!/usr/bin/env bash
# Installs the Debian packages of a build in a fresh Debian 12 and uses them there, as a user would: the tools, completion, man
# pages, and the examples built against the installed package. Needs root, debootstrap and the network.
#
#   tests/install/in_debian.sh [PACKAGES [SYSTEM]]
#
#   PACKAGES   folder of the .deb files [build/release/packages], made by `cpack --preset release`
#   SYSTEM     folder of the bare Debian 12, made when it is not there and never changed [build/debian-12]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
packages=${1:-build/release/packages} system=${2:-build/debian-12}
((EUID == 0)) || { echo "in_debian.sh: error: must be run as root, for chroot" >&2; exit 1; }

if [[ ! -e $system/etc/debian_version ]]; then
  rm -rf "$system.new"
  debootstrap --variant=minbase bookworm "$system.new" http://deb.debian.org/debian
  mv "$system.new" "$system"
fi

work=$(mktemp -d)
trap 'umount "$work/proc" 2> /dev/null || true; rm -rf "$work"' EXIT
cp -a "$system/." "$work"
cp /etc/resolv.conf "$work/etc/resolv.conf"
mkdir "$work/packages"
cp "$packages"/*.deb "$work/packages"
mount -t proc proc "$work/proc"

chroot "$work" bash -euxo pipefail << 'END'
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
apt-get -q update
apt-get -q -y --no-install-recommends install /packages/libuhas0_*.deb /packages/uhas-tools_*.deb

# the tools, with nothing of a compiler there
if command -v c++; then exit 1; fi
cd /root
uhas-build-profile /usr/share/uhas/hands/allegro_right/allegro_right.urdf -o allegro_right.h5
uhas-inspect allegro_right.h5 --validate
echo '[0,0,0,0,0, 0,0,0,0,0]' | uhas-solve - --profile allegro_right.h5
test -e /usr/share/bash-completion/completions/uhas-solve
test -e /usr/share/uhas/schemas/hand-profile-v1.md

# the libraries
apt-get -q -y --no-install-recommends install /packages/libuhas-dev_*.deb g++ cmake make pkg-config python3-numpy
cmake -S /usr/share/doc/uhas/examples -B examples
cmake --build examples
for example in 01_load 02_solve 03_control_loop 04_batch 05_observation 07_c; do examples/$example allegro_right.h5; done
examples/06_retarget allegro_right.h5 allegro_right.h5
python3 /usr/share/doc/uhas/examples/08_policy_loop.py /usr/lib/libuhas.so allegro_right.h5
c++ -std=c++20 /usr/share/doc/uhas/examples/02_solve.cpp $(pkg-config --cflags --libs uhas) -o solve
./solve allegro_right.h5

# and all of it leaves again
apt-get -q -y remove libuhas0
if command -v uhas-solve; then exit 1; fi
END
echo "The packages install, work and leave in a fresh Debian 12."
