#!/usr/bin/env bash
# setup/package.sh [FOLDER]: builds the Debian packages mwt, libmwt-dev and python3-mwt into FOLDER; build/packages if not given.
# Install them by: apt install FOLDER/*.deb
set -euo pipefail
folder=$(realpath -m "${1:-$(dirname "$0")/../build/packages}")
cd "$(dirname "$0")/.."

setup/build.sh release mwt mwt_verify mwt_library mwt_python
mkdir -p "$folder"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if ! cpack --config build/release/CPackConfig.cmake -B "$folder" >"$log" 2>&1; then
  cat "$log" >&2
  exit 3
fi
rm -rf "$folder/_CPack_Packages"
ls "$folder"/*.deb
