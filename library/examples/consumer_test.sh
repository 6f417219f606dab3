#!/usr/bin/env bash
# consumer_test.sh BUILD: installs the library that was built there, builds the example program against it, and runs it.
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$1" --prefix "$folder/installed" >"$folder/log" || { cat "$folder/log"; exit 1; }
cmake -S library/examples/cpp -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/installed" -DCMAKE_BUILD_TYPE=Release >"$folder/log" ||
  { cat "$folder/log"; exit 1; }
cmake --build "$folder/build" >"$folder/log" || { cat "$folder/log"; exit 1; }
printed=$("$folder/build/greedy_versus_optimum")
echo "$printed"
grep -q '^1000 points, greedy weighs 115\.3656886, the optimum 115\.2717791 (proved): alpha = 1\.000815$' <<<"$printed"
"$folder/build/greedy_versus_optimum" "$folder/none" 2>"$folder/log" && { echo "a missing file was accepted"; exit 1; }
grep -q 'no such file' "$folder/log"
