#!/usr/bin/env bash
# Makes the API documentation with Doxygen: build/docs/html/index.html. Fails on any warning.
set -euo pipefail
cd "$(dirname "$0")/.."

command -v doxygen >/dev/null || { echo "setup: no doxygen here; install it: setup/packages_for_checks.txt" >&2; exit 2; }
mkdir -p build
rm -rf build/docs
doxygen setup/Doxyfile
echo "$PWD/build/docs/html/index.html"
