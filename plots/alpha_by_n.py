#!/usr/bin/python3
"""Figure: by how much each algorithm exceeds the optimum, alpha - 1 by n, one panel per family.

    plots/alpha_by_n.py RESULTS_FOLDER -o FIGURE.svg [--families uniform,clustered] [--algorithms delaunay,greedy_report]

Reads RESULTS_FOLDER/runs.csv (schema: results/README.md) and writes FIGURE.svg and FIGURE.png. A point is the mean over
instances of the upper end of the certified interval, a bar reaches to the largest; runs without a proved optimum are
not drawn. The axis is logarithmic; below its lowest decade everything counts as optimal and lies on the bottom line.
Needs python3-pandas and python3-matplotlib.
"""
import argparse
import math
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
REPORT_ALGORITHMS = ["hull_insertion", "quadtree", "delaunay", "flip_report", "greedy_report"]
LOWEST_EXCESS = 1e-5
TEXT_COLUMNS = ("params", "generator_params")


def read_rated_runs(folder):
    """The runs with a certified alpha."""
    path = pathlib.Path(folder) / "runs.csv"
    if not path.is_file():
        sys.exit(f"{path}: no such file; make it with: mwt run STUDY --out {folder}")
    runs = pd.read_csv(path, keep_default_na=True, dtype={column: str for column in TEXT_COLUMNS})
    if set(runs["schema_version"]) - {1, 2}:
        sys.exit(f"{path}: a schema version that this script does not know")
    for column in TEXT_COLUMNS:
        runs[column] = runs[column].fillna("")
    return runs[(runs["status"] == "ok") & (runs["optimality"] == "proved")]


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
    """The report's own, or, in a study without them, those that are not always optimal."""
    of_report = [name for name in REPORT_ALGORITHMS if name in set(runs["label"])]
    worst = runs.groupby("label", sort=False)["alpha_upper"].max() - 1
    return of_report or list(worst[worst > LOWEST_EXCESS].index)


def draw_family(axes, runs, family, algorithms):
    for label, (colour, marker) in zip(algorithms, STYLES):
        cells = runs[(runs["family"] == family) & (runs["label"] == label)].groupby("n")["alpha_upper"]
        mean = (cells.mean() - 1).clip(lower=LOWEST_EXCESS)
        largest = (cells.max() - 1).clip(lower=LOWEST_EXCESS)
        axes.vlines(mean.index, mean, largest, color=colour, linewidth=0.9)
        axes.plot(mean.index, mean, label=label, color=colour, marker=marker, markersize=5, linewidth=1.4, clip_on=False)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(family, fontsize=10)
    axes.set_xlabel("points n")
    axes.grid(True, linewidth=0.4, color="#dddddd")
    axes.spines[["top", "right"]].set_visible(False)


def set_common_scale(all_axes):
    """The same decades for every panel; the lowest stands for optimal."""
    highest = max(axes.dataLim.y1 for axes in all_axes)
    decades = range(round(math.log10(LOWEST_EXCESS)), math.ceil(math.log10(highest)) + 1)
    ticks = [10.0**decade for decade in decades]
    labels = ["optimal"] + [f"{100 * tick:g} %" for tick in ticks[1:]]
    for axes in all_axes:
        axes.set_ylim(LOWEST_EXCESS, ticks[-1])
        axes.set_yticks(ticks, labels)
        axes.minorticks_off()


def draw(runs, families, algorithms):
    columns = min(3, len(families))
    rows = -(-len(families) // columns)
    figure, all_axes = plt.subplots(rows, columns, figsize=(3.6 * columns, 2.9 * rows + 0.6), squeeze=False)
    for axes, family in zip(all_axes.flat, families):
        draw_family(axes, runs, family, algorithms)
    set_common_scale(list(all_axes.flat)[:len(families)])
    for axes in list(all_axes.flat)[len(families):]:
        axes.set_visible(False)
    for axes in all_axes[:, 0]:
        axes.set_ylabel(r"excess $\alpha - 1$")
    handles, labels = all_axes.flat[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=min(5, len(labels)), frameon=False, fontsize=9)
    legend_height_inches = 0.12 + 0.2 * -(-len(labels) // 5)
    figure.tight_layout(rect=(0, legend_height_inches / figure.get_figheight(), 1, 1))
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", help="results folder of a study")
    parser.add_argument("-o", "--output", required=True, help="figure, .svg; a .png is written beside it")
    parser.add_argument("--families", default="", help="comma-separated; default: uniform, or all if there is none")
    parser.add_argument("--algorithms", default="", help="comma-separated; default: the report's")
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
