#!/usr/bin/env bash
# The command tests under Valgrind's memcheck: no invalid access, no use of uninitialised memory, no memory definitely lost.
#
#   tests/cli/run_valgrind.sh [TOOL...]        for example uhas-solve; by default all tools, one after the other
#
# Builds the preset `dev` first. A profile's build takes 4 to 5 s of processor time. tests/fuzz/RESULTS.md says what was found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

source packages/debian.sh
install_missing "${uhas_build_packages[@]}" "${uhas_test_packages[@]}" "${uhas_long_form_packages[@]}"
tools=("$@")
((${#tools[@]})) || mapfile -t tools < <(cd tests/cli && printf '%s\n' uhas-*)
cmake --preset dev
cmake --build --preset dev

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/bin" "$scratch/logs"
# In place of every tool, whichever a case calls and in whatever pipe. Errors go to files: a case compares stdout, stderr and exit
# code. The child processes that read files may write none: their exit codes tell of their errors, and their parents fail by them.
for tool in "$PWD"/build/dev/bin/uhas-*; do
  name=${tool##*/}
  cat > "$scratch/bin/$name" << END
#!/bin/sh
exec valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \\
  --num-callers=30 --log-file=$scratch/logs/$name.%p $tool "\$@"
END
  chmod +x "$scratch/bin/$name"
done

failed=()
for tool in "${tools[@]}"; do
  echo "== $tool"
  /usr/bin/python3 tests/cli/run_cases.py "$tool" --bin "$scratch/bin" --timeout 1800 || failed+=("$tool: cases")
  find "$scratch/logs" -type f -size +0 -exec cat {} + > "$scratch/errors"
  if [[ -s $scratch/errors ]]; then
    cat "$scratch/errors"
    failed+=("$tool: memory")
  fi
  rm -f "$scratch"/logs/*
done
((${#failed[@]} == 0)) || { printf 'FAILED: %s\n' "${failed[@]}"; exit 1; }
echo "Valgrind found nothing."
