#!/bin/sh
# Compiles fan_sweep.c if that has not been done, and runs it: points from standard input, triangles to standard output.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
built=${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/mwt/rivals
program=$built/fan_sweep-$(cksum < "$here/fan_sweep.c" | cut -d' ' -f1)
if [ ! -x "$program" ]; then
  mkdir -p "$built"
  ${CC:-cc} -O2 -o "$program.$$" "$here/fan_sweep.c"
  mv "$program.$$" "$program"
fi
exec "$program"
