#!/usr/bin/env bash
# Which lines of lib/ the tests run: builds the preset `coverage`, runs its tests, writes build/coverage/html/index.html, lists
# the lines that were not run in build/coverage/not_run and prints a line a room. Exits with 1 when a test failed or less than
# 90 % of all lines were run. COVERAGE.md says why the rest is not.
#
#   tests/coverage.sh [CTEST_ARGUMENT...]        for example -j 8
#
# The real hands take part when UHAS_HANDS_DIR is set, as in tests/run.sh. What costs much and runs no further line is left out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

source packages/debian.sh
install_missing "${uhas_build_packages[@]}" "${uhas_test_packages[@]}" "${uhas_long_form_packages[@]}"
! command -v ccache > /dev/null || export CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache

folder=build/coverage
cmake --preset coverage
cmake --build --preset coverage
find $folder -name '*.gcda' -delete
failed=0
ctest --preset coverage -j "$(nproc)" "$@" || failed=1

# geninfo's own redefinitions under Perl 5.36 are warned of, and nothing else
lcov --quiet --capture --directory $folder/lib --output-file $folder/all.info 2> >(grep -v ' redefined at ' >&2)
lcov --quiet --extract $folder/all.info "$PWD/lib/*" --output-file $folder/lib.info
genhtml --quiet --prefix "$PWD" --output-directory $folder/html $folder/lib.info
/usr/bin/python3 tests/support/line_coverage.py $folder/lib.info --not-run $folder/not_run --must 90 || failed=1
exit $failed
