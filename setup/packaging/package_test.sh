#!/usr/bin/env bash
# package_test.sh BUILD: makes the Debian packages of that build, unpacks them into a folder that goes away, and runs what they bring.
set -euo pipefail
cd "$(dirname "$0")/../.."
project=$PWD
build=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export MWT_CACHE_DIR=$folder/optima

fail() { echo "FAILED: $*" >&2; exit 1; }
quietly() { "$@" >"$folder/log" 2>&1 || { cat "$folder/log"; fail "$*"; }; }

quietly cpack --config "$build/CPackConfig.cmake" -B "$folder/packages"
packages=("$folder"/packages/*.deb)
[ ${#packages[@]} -eq 3 ] || fail "packages: ${packages[*]}"
# The rest of what lintian says concerns uploads to Debian.
quietly lintian --allow-root --fail-on error --suppress-tags initial-upload-closes-no-bugs "${packages[@]}"

root=$folder/root
for package in "${packages[@]}"; do dpkg-deb -x "$package" "$root"; done
[ "$(dpkg-deb -f "$folder"/packages/mwt_*.deb Version)" = "$("$root/usr/bin/mwt" --version | cut -d' ' -f2)-1" ] || fail "version"
for package in mwt libmwt-dev python3-mwt; do
  for file in copyright changelog.gz changelog.Debian.gz; do
    [ -s "$root/usr/share/doc/$package/$file" ] || fail "$package has no $file"
  done
done

# The programs, and studies that the installed program finds beside itself.
cd "$folder"
mwt=$root/usr/bin/mwt
studies=$("$mwt" list studies --json)
grep -q "\"file\": \"$root/usr/share/mwt/harness/studies/claims.toml\"" <<<"$studies" || fail "studies: $studies"
"$mwt" list studies | grep -q '^tsplib ' || fail "no study tsplib"
for study in tsplib claims rivals; do quietly "$mwt" run "$study" --dry-run; done
cat >small.toml <<END
name = "small"
summary = "A few runs"
families = ["uniform"]
sizes = [20, 50]
algorithms = ["greedy", "flip", { name = "fan_sweep", command = ["$root/usr/share/mwt/library/examples/rivals/fan_sweep.sh"] }]
END
quietly "$mwt" run small.toml --out records
[ "$(grep -c ',ok,' records/runs.csv)" -eq 6 ] || fail "not every run of the small study is ok"
export PYTHONDONTWRITEBYTECODE=1
quietly "$mwt" report records --page
[ -s records/report.html ] || fail "the installed program makes no page"
quietly "$mwt" generate uniform --n 100 -o points.txt
quietly "$mwt" solve points.txt --algorithm exact --proof proof.mwtproof
"$root/usr/bin/mwt_verify" points.txt proof.mwtproof | grep -q '^VERIFIED .*optimal' || fail "mwt_verify"

# Manual pages and completions.
for page in mwt mwt_verify; do
  MANWIDTH=100 man --warnings --manpath "$root/usr/share/man" "$page" >page 2>log || fail "man $page"
  [ ! -s log ] || { cat log; fail "warnings in the manual page of $page"; }
  grep -qE "^ *$page +- +" page || fail "$page has no name line"
done
man --manpath "$root/usr/share/man" mwt | grep -q -e '--with-optimum' || fail "no options in the manual page"
completed() {  # completed WORD...: what bash offers for the last word
  bash -c 'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _mwt; echo "${COMPREPLY[*]}"' \
    "$root/usr/share/bash-completion/completions/mwt" "$@"
}
expect_completion() {  # expect_completion EXPECTED WORD...
  local expected=$1
  shift
  [ "$(completed "$@")" = "$expected" ] || fail "completion of '$*' is '$(completed "$@")', not '$expected'"
}
expect_completion "solve" mwt so
expect_completion "greedy_naive greedy" mwt solve points.txt --algorithm gre
expect_completion "greedy_naive greedy" mwt solve --seed 3 --algorithm = gre
expect_completion "--threads --time-limit --triangles" mwt solve points.txt --t
expect_completion "points.txt" mwt solve poi
expect_completion "points.txt" mwt check --columns x,y points.txt poi
expect_completion "proof.mwtproof" mwt convert points.txt pr
expect_completion "records" mwt report re
expect_completion "claims claims_full" mwt run cla
expect_completion "algorithms" mwt list a
expect_completion "uniform_disc" mwt generate uniform_d
expect_completion "" mwt solve points.txt --seed ""
quietly zsh -n "$root/usr/share/zsh/vendor-completions/_mwt"
quietly bash -n "$root/usr/share/bash-completion/completions/mwt"

# The library and the Python module.
quietly cmake -S "$project/library/examples/cpp" -B consumer -G Ninja -DCMAKE_PREFIX_PATH="$root/usr" -DCMAKE_BUILD_TYPE=Release
quietly cmake --build consumer
grep -q "^mwt_DIR:PATH=$root/" consumer/CMakeCache.txt || fail "the consumer found another library"
consumer/greedy_versus_optimum | grep -q 'alpha = 1\.000815' || fail "consumer"
PYTHONPATH=$root/usr/lib/python3/dist-packages /usr/bin/python3 -c "
import mwt
assert mwt.__file__.startswith('$root'), mwt.__file__
points = mwt.generate('uniform', 1000, seed=1)
optimum = mwt.solve(points)
assert optimum.is_proved and mwt.triangulate(points).alpha(optimum).upper < 1.01" || fail "Python module"

# Nothing in the packages names a folder of this build.
! grep -rl "$folder" "$root" || fail "a folder of this test is in the packages"
echo "packages: $(cd "$folder/packages" && echo *.deb)"
