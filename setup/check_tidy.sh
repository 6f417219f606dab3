#!/usr/bin/env bash
# clang-tidy over every source that is not a test: minutes. *_kernels.cpp are
# left out: Google Highway compiles them once per instruction set, with macros that clang-tidy does not follow.
#   setup/check_tidy.sh [FILE...]   these sources only
set -euo pipefail
cd "$(dirname "$0")/.."

if [ $# -gt 0 ]; then
  sources=("$@")
else
  mapfile -t sources < <(find base geometry generators algorithms verifier harness -name '*.cpp' ! -name '*_test.cpp' ! -path '*/testing/*' ! -name '*_kernels.cpp' | sort)
fi
# The preset that compiles each source by itself; no build is needed.
cmake --preset sanitize >/dev/null
found=$(printf '%s\0' "${sources[@]}" |
  xargs -0 -n 4 -P "$(nproc)" clang-tidy --quiet -p build/sanitize 2>/dev/null) || {
  printf '%s\n' "$found" >&2
  echo "tidy: mend what is named above, or switch the check off in .clang-tidy with the reason" >&2
  exit 1
}
