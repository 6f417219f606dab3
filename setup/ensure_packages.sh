#!/usr/bin/env bash
# Installs the Debian packages listed in the given files, if any is missing. Elsewhere than on Debian, or without the
# right to install, it says exactly what is missing and stops.
set -euo pipefail

wanted=$(grep -hvE '^\s*(#|$)' "$@" | sort -u)

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is not a Debian system; install the equivalents of:" $wanted >&2
  exit 2
fi

missing=()
for package in $wanted; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null || ! sudo -n true 2>/dev/null && [ ! -t 0 ]; then
    echo "setup: missing packages: ${missing[*]}" >&2
    echo "setup: as root, run: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 2
  fi
  as_root=(sudo)
fi

echo "setup: installing ${missing[*]}"
if ! command -v apt-get >/dev/null; then
  echo "setup: no apt-get here; install: ${missing[*]}" >&2
  exit 2
fi
install() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# The package lists may be old or absent: refresh them, then install.
if ! { "${as_root[@]}" apt-get update && install; } >"$log" 2>&1; then
  tail -n 20 "$log" >&2
  echo "setup: could not install: ${missing[*]}" >&2
  exit 2
fi
