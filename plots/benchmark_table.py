#!/usr/bin/python3
"""Table: time over the Delaunay time by n, growth and gap, from a run of mwt_benchmark. Prints Markdown.

    build/release/mwt_benchmark --benchmark_filter='/uniform/' --benchmark_out=FILE.json
    plots/benchmark_table.py FILE.json [--family uniform] [--min_n 1000]

One line per algorithm: over_delaunay at each n; the exponent fitted to the processor times (least squares of log time by
log n); the gap, alpha_upper - 1, at the largest n with a certified alpha. `-` where a cell was skipped or not run.
With --benchmark_repetitions the medians count. Needs nothing but Python.
"""
import argparse
import json
import math
import pathlib
import sys

MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}


def read_cells(path, family):
    """{algorithm: {n: cell}} of the family, in the order of the file."""
    try:
        rows = json.loads(pathlib.Path(path).read_text())["benchmarks"]
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"{path}: no output of mwt_benchmark in JSON ({error}); make it with --benchmark_out={path}")
    has_medians = any(row.get("aggregate_name") == "median" for row in rows)
    cells = {}
    for row in rows:
        algorithm, row_family, n = row["run_name"].split("/")[:3]
        wanted = row.get("aggregate_name") == "median" if has_medians else row["run_type"] == "iteration"
        if row_family == family and wanted and not row.get("error_occurred"):
            cells.setdefault(algorithm, {})[int(n)] = row
    if not cells:
        sys.exit(f"{path}: nothing on the family {family}")
    return cells


def exponent(cells):
    """The slope of log time by log n, empty for fewer than two sizes."""
    pairs = [(math.log(n), math.log(row["cpu_time"] * MILLISECONDS[row["time_unit"]])) for n, row in cells.items()]
    if len(pairs) < 2:
        return "-"
    mean_x = sum(x for x, _ in pairs) / len(pairs)
    mean_y = sum(y for _, y in pairs) / len(pairs)
    slope = sum((x - mean_x) * (y - mean_y) for x, y in pairs) / sum((x - mean_x) ** 2 for x, _ in pairs)
    return f"{slope:.2f}"


def gap(cells):
    """How far above the optimum, and at which n."""
    rated = [n for n, row in cells.items() if "alpha_upper" in row]
    if not rated:
        return "-"
    percent = 100 * (cells[max(rated)]["alpha_upper"] - 1)
    text = "< 1e-10%" if percent < 1e-10 else f"{percent:,.0f}%" if percent > 100 else f"{percent:.2g}%"
    return f"{text} at {max(rated):,}"


def print_table(cells, sizes):
    print("| algorithm | " + " | ".join(f"{n:,}" for n in sizes) + " | exponent | gap to the optimum |")
    print("|---" * (len(sizes) + 3) + "|")
    for algorithm, by_n in cells.items():
        kept = {n: row for n, row in by_n.items() if n in sizes}
        if kept:
            ratios = [f"{kept[n]['over_delaunay']:.2f}" if n in kept else "-" for n in sizes]
            print(f"| `{algorithm}` | " + " | ".join(ratios) + f" | {exponent(kept)} | {gap(kept)} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("--family", default="uniform")
    parser.add_argument("--min_n", type=int, default=1000)
    arguments = parser.parse_args()
    cells = read_cells(arguments.file, arguments.family)
    sizes = sorted({n for by_n in cells.values() for n in by_n if n >= arguments.min_n})
    print_table(cells, sizes)


if __name__ == "__main__":
    main()
