#!/usr/bin/env bash
# Formatting, and the rule of the layers: each includes only layers below it; heavy headers stay in few source files.
set -euo pipefail
cd "$(dirname "$0")/.."

layers=(base geometry generators algorithms harness)
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
# What only tests include may look further: x_test.cpp and x_testing.h.
code_of() { find "$1" \( -name '*.h' -o -name '*.cpp' \) ! -name '*_test.cpp' ! -name '*testing.h'; }

mapfile -t geometry < <(code_of geometry)
mapfile -t generators < <(code_of generators)
mapfile -t algorithms < <(code_of algorithms)
mapfile -t headers < <(find "${layers[@]}" -name '*.h')
forbid '#include "(generators|algorithms|harness)/' 'geometry is the lowest layer' "${geometry[@]}"
forbid '#include "(algorithms|harness)/' 'generators include geometry only' "${generators[@]}"
forbid '#include "(generators|harness)/' 'algorithms include geometry only' "${algorithms[@]}"
forbid '#include <(CGAL|Eigen|CLI|nlohmann|toml|boost/math|benchmark|glpk|sqlite3)' 'heavy headers belong in few .cpp files' "${headers[@]}"

# CMakeLists.txt states the version; what people and programs read elsewhere must agree.
version=$(sed -n 's/^project(.* VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
agrees() {  # agrees FILE LINE
  grep -qxF "$2" "$1" || { echo "style: $1 has no line '$2', but CMakeLists.txt has version $version" >&2; failed=yes; }
}
agrees CITATION.cff "version: $version"
agrees CHANGELOG.md "## $version"
[ "$failed" = no ]
