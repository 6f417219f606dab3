#!/usr/bin/env bash
# changelog.sh VERSION MAINTAINER FOLDER: writes FOLDER/changelog.gz, which is CHANGELOG.md, and FOLDER/changelog.Debian.gz, dated
# as the release is in CITATION.cff, so that two builds of one commit are the same.
set -euo pipefail
cd "$(dirname "$0")/../.."
version=$1 maintainer=$2 folder=$3

mkdir -p "$folder"
gzip -9n <CHANGELOG.md >"$folder/changelog.gz"
released=$(sed -n 's/^date-released: //p' CITATION.cff)
date=$(LC_ALL=C date --utc --date "$released" '+%a, %d %b %Y %H:%M:%S +0000')
printf 'mwt (%s) unstable; urgency=medium\n\n  * Release %s: see changelog.gz.\n\n -- %s  %s\n' \
  "$version" "${version%-*}" "$maintainer" "$date" | gzip -9n >"$folder/changelog.Debian.gz"
