#!/usr/bin/env bash
# Formatting, and the rule of the layers: each includes only layers below it; heavy headers stay in few source files.
set -euo pipefail
cd "$(dirname "$0")/.."

layers=(base geometry generators algorithms verifier harness library)
mapfile -t sources < <(find "${layers[@]}" -name '*.h' -o -name '*.cpp' | sort)
clang-format --dry-run --Werror "${sources[@]}"

failed=no
forbid() {  # forbid PATTERN WHY FILE...
  local pattern=$1 why=$2
  shift 2
  if grep -nE "$pattern" "$@"; then
    echo "style: $why" >&2
    failed=yes
  fi
}
forbid_others() {  # forbid_others PATTERN ALLOWED WHY FILE...: lines with the pattern that are none of those allowed
  local pattern=$1 allowed=$2 why=$3
  shift 3
  if grep -nE "$pattern" "$@" | grep -vE "$allowed"; then
    echo "style: $why" >&2
    failed=yes
  fi
}
# What only tests include may look further: x_test.cpp and the folders testing/.
code_of() { find "$1" \( -name '*.h' -o -name '*.cpp' \) ! -name '*_test.cpp' ! -path '*/testing/*'; }

# Each layer, and each room of the harness, includes only those before it in its list.
require_order() {  # require_order PREFIX NAME...
  local prefix=$1 later
  shift
  while [ $# -gt 1 ]; do
    local name=$1
    shift
    later=$(IFS='|'; echo "$*")
    mapfile -t files < <(code_of "$prefix$name")
    forbid "#include \"$prefix($later)/" "$prefix$name/ includes only what is below it" "${files[@]}"
  done
}
require_order "" base geometry generators algorithms verifier harness library
mapfile -t algorithms < <(code_of algorithms)
forbid '#include "generators/' 'algorithms and generators do not include each other' "${algorithms[@]}"
mapfile -t verifier < <(find verifier -name '*.h' -o -name '*.cpp')
forbid '#include "(generators|algorithms|harness)/' 'the verifier shares no code with solvers, not even in its tests' "${verifier[@]}"
forbid_others '#include "(base|geometry)/' '#include "(geometry/point|base/error|base/testing/test_folder)\.h"' \
  'of base/ and geometry/ the verifier includes points, errors and the folder of tests' "${verifier[@]}"
require_order harness/ io statistics run rating records study archive claims report paper tracking hunt benchmark explore cli
# Only the registries include the rooms of the single claims and commands.
mapfile -t others < <(code_of harness | grep -vE '^harness/(claims/(claims.cpp|rules/)|cli/(mwt_main.cpp|commands/))')
forbid '#include "harness/(claims/rules|cli/commands)/' 'claims/claims.cpp and cli/mwt_main.cpp alone list claims and commands' "${others[@]}"
mapfile -t headers < <(find "${layers[@]}" -name '*.h')
forbid '#include <(CGAL|Eigen|CLI|fmt|nlohmann|toml|boost/math|benchmark|glpk|sqlite3|SQLiteCpp|httplib)' 'heavy headers belong in few .cpp files' "${headers[@]}"
forbid_loose=$(find harness -maxdepth 1 -type f)
[ -z "$forbid_loose" ] || { echo "style: harness/ has no files of its own, only rooms: $forbid_loose" >&2; failed=yes; }

# CMakeLists.txt states the version; what people and programs read elsewhere must agree.
version=$(sed -n 's/^project(.* VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
agrees() {  # agrees FILE LINE
  grep -qxF "$2" "$1" || { echo "style: $1 has no line '$2', but CMakeLists.txt has version $version" >&2; failed=yes; }
}
agrees CITATION.cff "version: $version"
agrees CHANGELOG.md "## $version"
[ "$failed" = no ]
