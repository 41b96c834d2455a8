#!/usr/bin/env bash
# The command tests under Valgrind's memcheck: no invalid access, no use of uninitialised memory, no memory definitely lost.
#
#   tests/cli/run_valgrind.sh [FOLDER...]      of cases, for example uhas-solve; by default all, one after the other
#
# Builds the preset `dev` first. A profile's build takes 4 to 5 s of processor time. tests/fuzz/RESULTS.md says what was found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

source packages/debian.sh
install_missing "${uhas_build_packages[@]}" "${uhas_test_packages[@]}" "${uhas_long_form_packages[@]}"
folders=("$@")
((${#folders[@]})) || mapfile -t folders < <(cd tests/cli && printf '%s\n' every_tool uhas-*)
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
for folder in "${folders[@]}"; do
  echo "== $folder"
  /usr/bin/python3 tests/cli/run_cases.py "$folder" --bin "$scratch/bin" --timeout 1800 || failed+=("$folder: cases")
  find "$scratch/logs" -type f -size +0 -exec cat {} + > "$scratch/errors"
  if [[ -s $scratch/errors ]]; then
    cat "$scratch/errors"
    failed+=("$folder: memory")
  fi
  rm -f "$scratch"/logs/*
done
((${#failed[@]} == 0)) || { printf 'FAILED: %s\n' "${failed[@]}"; exit 1; }
echo "Valgrind found nothing."
