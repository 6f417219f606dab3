"""Running times by n with fitted lines."""
import matplotlib.pyplot as plt
import numpy as np

from figures.fits import power_law
from library.style import Styles, legend_below, report_first

TITLE = "Running time by n"
CAPTION = (
    "Median wall time of the algorithm alone on uniform points; lines are fitted through the logarithms of the upper"
    " half of the sizes, and the legend states their slope: the time grows like n to that power. The report's literal"
    " algorithms are on the left, their fast counterparts and the exact solvers on the right; brute_force and subset_dp"
    " are exponential."
)
PANELS = {
    "as the report writes them": (
        "brute_force",
        "greedy_report",
        "hull_insertion",
        "flip_report",
        "quadtree",
        "delaunay",
    ),
    "fast and exact": (
        "sweep",
        "delaunay",
        "greedy",
        "flip",
        "patch",
        "annealing",
        "subset_dp",
        "triangle_lp",
        "exact",
    ),
}
FAMILY = "uniform"
SMALLEST_FITTED_TIME_S = 2e-5
EXPONENTIAL = ("brute_force", "subset_dp")  # no power of n fits them


def fitted(times):
    """The slope over the upper half of the sizes, which small costs disturb least; None if there are too few."""
    times = times[times > SMALLEST_FITTED_TIME_S]
    upper = times[len(times) // 2 :] if len(times) > 5 else times
    return power_law(upper.index.to_numpy(float), upper.to_numpy()) + (upper.index,) if len(upper) > 2 else None


def draw_panel(axes, runs, labels, styles):
    for label in labels:
        times = runs[runs["label"] == label].groupby("n")["wall_time_s"].median()
        style = dict(styles[label], linestyle="")
        fit = None if label in EXPONENTIAL else fitted(times)
        name = label
        if fit:
            exponent, factor, sizes = fit
            ends = np.array([sizes[0], sizes[-1]], float)
            axes.plot(ends, factor * ends**exponent, color=styles.colour(label), linewidth=1.1)
            name = f"{label}  $n^{{{exponent:.2f}}}$"
        axes.plot(times.index, times, label=name, **style)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("points n")
    axes.minorticks_off()
    axes.legend(
        fontsize=7.5, loc="upper left", bbox_to_anchor=(-0.02, -0.13), ncol=3, handletextpad=0.2, columnspacing=0.8
    )


def draw(results):
    runs = results.runs
    runs = runs[
        (runs["family"] == FAMILY)
        & (runs["status"] == "ok")
        & runs["wall_time_s"].notna()
        & (runs["stopped_early"] == 0)
    ]
    panels = {
        title: [label for label in report_first(set(runs["label"])) if label in names]
        for title, names in PANELS.items()
    }
    if not any(panels.values()):
        return None
    figure, all_axes = plt.subplots(1, 2, figsize=(9.4, 4.9), sharey=True)
    for axes, (title, labels) in zip(all_axes, panels.items()):
        draw_panel(axes, runs, labels, Styles(labels))
        axes.set_title(title)
    low, high = all_axes[0].get_ylim()
    ticks = {
        1e-6: "1 µs",
        1e-5: "10 µs",
        1e-4: "100 µs",
        1e-3: "1 ms",
        1e-2: "10 ms",
        1e-1: "100 ms",
        1: "1 s",
        10: "10 s",
        100: "100 s",
    }
    shown = [tick for tick in ticks if low <= tick <= high * 2]
    all_axes[0].set_yticks(shown, [ticks[tick] for tick in shown])
    all_axes[0].set_ylabel("wall time")
    figure.tight_layout()
    return figure
