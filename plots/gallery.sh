#!/usr/bin/env bash
# Makes what the gallery draws, with the program itself, after mwt report: plots/gallery.sh MWT RESULTS_FOLDER
#   RESULTS_FOLDER/gallery/SET.csv        the points
#   RESULTS_FOLDER/gallery/SET.NAME.csv   the triangles of one algorithm, SET.NAME.json the output of mwt solve
#   RESULTS_FOLDER/gallery/tour.html      recorded steps, of the study claims (make_tour.py)
set -euo pipefail

mwt=$(realpath "$1")
plots=$(realpath "$(dirname "$0")")
studies=$plots/../harness/studies
results=$(realpath "$2")
mkdir -p "$results/gallery"
cd "$results/gallery"
rm -f -- *.csv *.json tour.html

solve() {  # solve SET NAME ALGORITHM [OPTION...]
  local set=$1 name=$2 algorithm=$3
  shift 3
  "$mwt" solve "$set.csv" --algorithm "$algorithm" --with-optimum --json --triangles "$set.$name.csv" "$@" >"$set.$name.json"
}

# The same points triangulated by every algorithm of the study; some take special points only.
"$mwt" generate uniform --n 60 --seed 3 -o same_points.csv
solve same_points optimum exact
"$plots/study_algorithms.py" "$results" 60 | while IFS=$'\t' read -r name algorithm parameters commands; do
  options=()
  [ -z "$commands" ] || options+=(--commands "$commands")
  for parameter in $parameters; do options+=(--param "$parameter"); done
  if ! solve same_points "$name" "$algorithm" "${options[@]}"; then
    rm -f -- "same_points.$name.csv" "same_points.$name.json"
    echo "gallery: without $name" >&2
  fi
done

# The rest illustrates the source report.
[ -f "$results/claims.csv" ] || exit 0

# Its worked examples: greedy, hull insertion, and the local search flip by flip.
"$mwt" generate report_example -o report_example.csv
solve report_example greedy_naive greedy_naive
solve report_example hull_insertion hull_insertion
solve report_example exact exact
"$mwt" generate local_search_figure -o local_search_figure.csv
for flips in 0 1 2; do
  solve local_search_figure "flips$flips" flip_naive \
    --param start="$studies/local_search_figure_start.csv" --param max_flips="$flips"
done
solve local_search_figure exact exact

# The same and more, step by step. An installed mwt has no recorder.
[ ! -f "$plots/make_tour.py" ] || "$plots/make_tour.py" "$mwt" tour.html >/dev/null

# The step of its proof that fails: the hull alone weighs more than the optimum with the inner point.
"$mwt" generate hull_bound_counterexample -o hull_bound_counterexample.csv
solve hull_bound_counterexample exact exact
head -n 13 hull_bound_counterexample.csv >hull_only.csv
solve hull_only exact exact

# What the quadtree's grid looks like.
"$mwt" generate clustered --n 150 --seed 2 -o grid_points.csv
solve grid_points quadtree quadtree
solve grid_points exact exact
