"""Gap against time, a panel per n, with the Pareto front."""
import numpy as np
from matplotlib.ticker import NullFormatter

from .data import legend_below, mark, panel_height, panels

SMALLEST = 1e-6  # percent: gaps of 0 are drawn at the bottom, below a gap in the axis


def trade_off(data):
    if not data.has("trade_off"):
        return None
    table = data.table("trade_off")
    looks = data.looks()
    sizes = list(dict.fromkeys(table["n"]))
    figure, all_axes = panels(len(sizes), panel_height(table["label"]))
    positive = 100 * table["gap_mean"][table["gap_mean"] > 0]
    bottom = max(positive.min() / 30, SMALLEST) if len(positive) else SMALLEST
    for axes, n in zip(all_axes, sizes):
        of_n = table[table["n"] == n]
        draw_panel(axes, of_n, looks, bottom)
        axes.set_title(f"$n={n}$", loc="left")
        axes.set_xlabel("time in s")
        axes.set_ylim(bottom / 2, (positive.max() if len(positive) else 1) * 3)
        if (of_n["gap_mean"] <= 0).any():
            name_zero(axes, bottom)
    for axes in all_axes[1:]:
        axes.set_yticklabels([])
    all_axes[0].set_ylabel("mean gap in percent")
    legend_below(figure, looks, list(dict.fromkeys(table["label"])))
    return figure


def draw_panel(axes, of_n, looks, bottom):
    axes.set_xscale("log")
    axes.set_yscale("log")
    front = of_n[of_n["is_pareto"] == 1].sort_values("time_median_s")
    axes.plot(front["time_median_s"], height(front["gap_mean"], bottom), color="#999999", linewidth=0.8, zorder=1, drawstyle="steps-post")
    for row in of_n.itertuples():
        x, y = row.time_median_s, float(height(row.gap_mean, bottom))
        if not np.isnan(row.gap_mean_lower) and row.gap_mean > 0:
            ends = height(np.array([row.gap_mean_lower, row.gap_mean_upper]), bottom)
            axes.plot([x, x], ends, color=looks[row.label]["color"], linewidth=0.7)
        if not np.isnan(row.time_median_s_lower):
            axes.plot([row.time_median_s_lower, row.time_median_s_upper], [y, y], color=looks[row.label]["color"], linewidth=0.7)
        axes.plot(x, y, **mark(looks[row.label]))
    show_whole_decades(axes)


def show_whole_decades(axes):
    """Narrow panels have room for a few powers of ten, and none for what lies between."""
    first, last = np.log10(axes.get_xlim())
    axes.set_xlim(10.0 ** np.floor(first), 10.0 ** np.ceil(last))
    axes.xaxis.set_minor_formatter(NullFormatter())


def height(gap, bottom):
    """In percent; 0 at the bottom."""
    return np.maximum(100 * gap, bottom)


def name_zero(axes, bottom):
    axes.axhline(bottom, color="#bbbbbb", linewidth=0.5, linestyle=(0, (2, 2)), zorder=0)
    axes.annotate("0", (0, bottom), xycoords=("axes fraction", "data"), xytext=(2, 2), textcoords="offset points", fontsize=6)
