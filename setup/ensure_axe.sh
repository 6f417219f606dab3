#!/usr/bin/env bash
# Installs axe-core, by which tests check that pages are accessible, into setup/axe/node_modules: the version in package-lock.json.
# Without npm or a network it says so, and those tests are skipped.
set -euo pipefail
cd "$(dirname "$0")/axe"

[ -f node_modules/axe-core/axe.min.js ] && exit 0
if ! command -v npm >/dev/null; then
  echo "setup: npm is missing: pages are not checked by axe-core" >&2
elif ! npm ci --no-audit --no-fund --silent; then
  echo "setup: axe-core could not be installed: pages are not checked by it" >&2
fi
