#!/usr/bin/env bash
# Installs the packages that are missing, builds uhas with warnings as errors and runs every test; then the unit tests again
# under AddressSanitizer with UndefinedBehaviorSanitizer, each fuzz target for 30 seconds, and the runtime library's tests under
# ThreadSanitizer; then runs the quick start, compares what its build makes with what the first one does, makes the Debian
# packages and uses them; then builds, installs and uses the runtime library alone.
# Ends with one line a suite and what was skipped, by name; exits with 0 when everything passed.
#
#   UHAS_HANDS_DIR   folder of real hands, one folder a hand with its truth.json. When it is not set, the tests on real hands
#                    are skipped; when it is set but holds no hands, nothing is run.
set -euo pipefail

if [[ -n ${UHAS_HANDS_DIR+set} ]]; then
  if [[ -z $(find -L "$UHAS_HANDS_DIR" -mindepth 2 -maxdepth 2 -name truth.json -print -quit 2> /dev/null) ]]; then
    echo "tests/run.sh: error: UHAS_HANDS_DIR is \"$UHAS_HANDS_DIR\": no */truth.json there; name a folder of hands or unset it" >&2
    exit 1
  fi
  UHAS_HANDS_DIR=$(realpath "$UHAS_HANDS_DIR")
  export UHAS_HANDS_DIR
fi
cd "$(dirname "${BASH_SOURCE[0]}")/.."

source packages/debian.sh
install_missing "${uhas_build_packages[@]}" "${uhas_test_packages[@]}"

jobs=$(nproc)
! command -v ccache > /dev/null || export CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache
failed=()

# All steps are tried, so that one run tells everything; `failed` names those that failed.
build() { # PRESET
  cmake --preset "$1" && cmake --build --preset "$1" --parallel "$jobs" || { failed+=("build of $1"); return 1; }
}

run_tests() { # PRESET
  ctest --preset "$1" -j "$jobs" --output-on-failure --no-tests=error --test-output-size-passed 1000000 \
    --output-junit results.xml || failed+=("tests of $1")
}

for preset in dev fuzz tsan; do
  rm -f "build/$preset/results.xml"
  if build "$preset"; then run_tests "$preset"; fi
done
# the quick start builds `release`, from which the packages are made
if examples/quickstart.sh; then
  /usr/bin/python3 tests/determinism/same_bytes.py --bin build/dev/bin --bin build/release/bin --hand allegro_left \
    --hand shadow_right || failed+=("the same bytes from two builds")
  packages=build/release/packages
  rm -rf "$packages"
  cpack --preset release && /usr/bin/python3 tests/install/check_packages.py "$packages" &&
    /usr/bin/python3 tests/install/check_install.py "$packages" || failed+=("the Debian packages")
else
  failed+=("the quick start")
fi
if build runtime-only; then
  profile=build/runtime-only/allegro_right.h5
  build/dev/bin/uhas-build-profile --quiet hands/allegro_right/allegro_right.urdf -o "$profile" &&
    /usr/bin/python3 tests/install/check_install.py build/runtime-only --profile "$profile" ||
    failed+=("the runtime library, installed alone")
fi

for preset in dev fuzz tsan; do
  [[ -e build/$preset/results.xml ]] || continue
  echo "== $preset"
  /usr/bin/python3 tests/support/summary.py "build/$preset" "build/$preset/results.xml" || failed+=("summary of $preset")
done
if ((${#failed[@]})); then
  printf 'FAILED: %s\n' "${failed[@]}"
  exit 1
fi
echo "Everything passed: the tests, the quick start, the same bytes, the Debian packages, the runtime library alone."
