#!/usr/bin/env bash
# Configures and builds one CMake preset: setup/build.sh PRESET [TARGET...]. A second run does only what changed.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=$1
shift
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if ! cmake --preset "$preset" >"$log" 2>&1; then
  cat "$log" >&2
  echo "setup: configuring preset $preset failed" >&2
  exit 3
fi
options=()
[ -t 1 ] || options=(-- --quiet)  # a line per file is progress on a terminal, where it is rewritten; elsewhere it is noise
targets=()
[ $# -eq 0 ] || targets=(--target "$@")
cmake --build --preset "$preset" "${targets[@]}" "${options[@]}"
