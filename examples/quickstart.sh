#!/usr/bin/env bash
# From a fresh Debian machine to joint angles: installs the packages that are missing, builds uhas, makes the profile of the
# Allegro hand in hands/allegro_right and solves the actions of first_actions.json. Writes only below build/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

source packages/debian.sh
install_missing "${uhas_build_packages[@]}"

cmake --preset release
cmake --build --preset release --parallel "$(nproc)"

bin=build/release/bin out=build/quickstart
mkdir -p "$out"
"$bin/uhas-build-profile" hands/allegro_right/allegro_right.urdf -o "$out/allegro_right.h5"
"$bin/uhas-solve" examples/first_actions.json --profile "$out/allegro_right.h5" -o "$out/solution.json"
"$bin/uhas-inspect" "$out/allegro_right.h5" > "$out/allegro_right.txt"
"$bin/uhas-inspect" "$out/allegro_right.h5" --quiet --html "$out/allegro_right.html" --urdf hands/allegro_right/allegro_right.urdf

cat << END

Made in $PWD/$out:
  allegro_right.h5    the profile of the hand: what the runtime library loads
  solution.json       the joint angles for each action of examples/first_actions.json
  allegro_right.txt   what uhas-inspect says of the profile
  allegro_right.html  the hand to be moved by sliders, in any browser
The tools are in $PWD/$bin; next: uhas-build-profile with the URDF of your own hand.
END
