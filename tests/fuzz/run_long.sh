#!/usr/bin/env bash
# The long form of the fuzz tests: every target in turn, coverage-guided, with what it finds kept in build/fuzz/long/<target>.
#
#   tests/fuzz/run_long.sh [SECONDS_PER_TARGET [TARGET...]]        by default an hour for each of all targets
#
# Builds the preset `fuzz` first. A crash, hang, leak or over-allocation leaves its input there and ends in exit code 1;
# `build/fuzz/bin/fuzz_<target> INPUT` runs it again. RESULTS.md says what was found so far.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

seconds=${1:-3600}
shift || true
targets=("$@")
if ((${#targets[@]} == 0)); then
  targets=(urdf hand_config mesh actions profile_file profile_values solver)
fi
cmake --preset fuzz
cmake --build --preset fuzz

failed=()
for target in "${targets[@]}"; do
  folder=build/fuzz/long/$target
  mkdir -p "$folder/corpus"
  seeds=tests/fuzz/corpus/$target
  [[ -d $seeds ]] || seeds=
  # shellcheck disable=SC2086  # no seeds, no argument
  "build/fuzz/bin/fuzz_$target" "$folder/corpus" $seeds -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 \
    -malloc_limit_mb=1024 -max_len=4096 -print_final_stats=1 -artifact_prefix="$folder/" 2> "$folder/log" ||
    failed+=("$target: see $folder")
  sed -n 's/^stat::number_of_executed_units: */'"$target"': inputs tried: /p' "$folder/log"
done
((${#failed[@]} == 0)) || { printf 'FAILED: %s\n' "${failed[@]}"; exit 1; }
