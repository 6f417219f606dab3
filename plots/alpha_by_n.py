#!/usr/bin/python3
"""Figure: the approximation factor alpha by n, one line per algorithm, one panel per family.

    plots/alpha_by_n.py RESULTS_FOLDER -o FIGURE.svg [--families uniform,clustered] [--algorithms delaunay,greedy_report]

Reads RESULTS_FOLDER/runs.csv (schema: results/README.md) and writes FIGURE.svg and FIGURE.png. A point is the mean over
instances of the upper end of the certified interval, a bar reaches to the largest; runs without a certified bound are
not drawn. Needs python3-pandas and python3-matplotlib.
"""
import argparse
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import pandas as pd

# Okabe and Ito's colours, which the colour-blind can tell apart; with a marker each, for print in grey.
STYLES = [
    ("#0072B2", "o"), ("#D55E00", "s"), ("#009E73", "^"), ("#CC79A7", "D"),
    ("#E69F00", "v"), ("#56B4E9", "P"), ("#000000", "X"), ("#999999", "*"),
]
MOST_ALGORITHMS = len(STYLES)
TEXT_COLUMNS = ("params", "generator_params")


def read_rated_runs(folder):
    """The runs with a certified alpha."""
    path = pathlib.Path(folder) / "runs.csv"
    if not path.is_file():
        sys.exit(f"{path}: no such file; make it with: mwt run STUDY --out {folder}")
    runs = pd.read_csv(path, keep_default_na=True, dtype={column: str for column in TEXT_COLUMNS})
    if set(runs["schema_version"]) - {1}:
        sys.exit(f"{path}: a schema version that this script does not know")
    for column in TEXT_COLUMNS:
        runs[column] = runs[column].fillna("")
    return runs[(runs["status"] == "ok") & runs["alpha_upper"].notna()]


def with_labels(runs):
    """Adds the columns `label` and `family`: a name alone, or with its parameters where a study has several."""
    runs = runs.copy()
    for label, name, parameters in (("label", "algorithm", "params"), ("family", "generator", "generator_params")):
        several = runs.groupby(name)[parameters].transform("nunique") > 1
        runs[label] = runs[name].where(~several, runs[name] + " " + runs[parameters])
    return runs


def chosen(column, wanted, default):
    """The wanted values in their order, all of which have to be there; the default if none are named."""
    if not wanted:
        return default
    names = wanted.split(",")
    missing = [name for name in names if name not in set(column)]
    if missing:
        sys.exit(f"no rated runs of {', '.join(missing)}; there are: {', '.join(sorted(set(column)))}")
    return names


def default_algorithms(runs):
    """Those that are not always optimal: a line at 1 says nothing. In the order of the records."""
    worst = runs.groupby("label", sort=False)["alpha_upper"].max()
    return list(worst[worst > 1 + 1e-9].index)[:MOST_ALGORITHMS]


def draw_family(axes, runs, family, algorithms):
    for label, (colour, marker) in zip(algorithms, STYLES):
        cells = runs[(runs["family"] == family) & (runs["label"] == label)].groupby("n")["alpha_upper"]
        mean, largest = cells.mean(), cells.max()
        axes.errorbar(mean.index, mean, yerr=[0 * mean, largest - mean], label=label, color=colour, marker=marker,
                      markersize=5, linewidth=1.4, capsize=2, elinewidth=0.8)
    axes.axhline(1, color="#666666", linewidth=0.8)
    axes.set_xscale("log")
    axes.set_title(family, fontsize=10)
    axes.set_xlabel("points n")
    axes.grid(True, linewidth=0.4, color="#dddddd")
    axes.spines[["top", "right"]].set_visible(False)


def draw(runs, families, algorithms):
    columns = min(3, len(families))
    rows = -(-len(families) // columns)
    figure, all_axes = plt.subplots(rows, columns, figsize=(3.6 * columns, 2.9 * rows + 0.6), squeeze=False)
    for axes, family in zip(all_axes.flat, families):
        draw_family(axes, runs, family, algorithms)
    for axes in list(all_axes.flat)[len(families):]:
        axes.set_visible(False)
    for axes in all_axes[:, 0]:
        axes.set_ylabel(r"$\alpha = w(T)\,/\,w(T^*)$")
    handles, labels = all_axes.flat[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=min(4, len(labels)), frameon=False, fontsize=9)
    figure.tight_layout(rect=(0, 0.04 + 0.07 * (-(-len(labels) // 4)) / rows, 1, 1))
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", help="results folder of a study")
    parser.add_argument("-o", "--output", required=True, help="figure, .svg; a .png is written beside it")
    parser.add_argument("--families", default="", help="comma-separated; default: uniform, or all if there is none")
    parser.add_argument("--algorithms", default="", help="comma-separated; default: those that are not always optimal")
    arguments = parser.parse_args()

    runs = with_labels(read_rated_runs(arguments.folder))
    if runs.empty:
        sys.exit(f"{arguments.folder}: no run has a certified alpha")
    known = list(dict.fromkeys(runs["family"]))
    families = chosen(runs["family"], arguments.families, ["uniform"] if "uniform" in known else known)
    algorithms = chosen(runs["label"], arguments.algorithms, default_algorithms(runs))[:MOST_ALGORITHMS]
    if not algorithms:
        sys.exit("every algorithm is optimal everywhere; name some with --algorithms")

    # Text as text, and no date or random ids: the same results give the same file.
    plt.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "mwt", "font.size": 9})
    figure = draw(runs, families, algorithms)
    output = pathlib.Path(arguments.output).with_suffix(".svg")
    output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(output, metadata={"Date": None})
    figure.savefig(output.with_suffix(".png"), dpi=160)
    print(f"{output}, {output.with_suffix('.png')}")


if __name__ == "__main__":
    main()
