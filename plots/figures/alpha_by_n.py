"""By how much the algorithms exceed the optimum, alpha - 1 by n, one panel per family."""
import math

import matplotlib.pyplot as plt

from library.records import RANDOM_FAMILIES
from library.style import INK, Styles, legend_below, report_first

TITLE = "How far from the optimum, by n"
CAPTION = (
    "A point is the mean over instances of α − 1, a bar reaches to the largest; both axes are logarithmic. The shaded"
    " band is the report's 1.1–1.5. Every optimum is proved: its certified interval is narrower than a millionth of a"
    " point on this page, so that error bars for it cannot be seen. What is below the axis's lowest decade lies on the"
    " line “optimal”. greedy_report, the report's literal version, gives the same triangulations as greedy."
)
SHOWN = ("hull_insertion", "quadtree", "delaunay", "flip_report", "greedy", "patch")
LOWEST_EXCESS = 1e-5
MOST_FAMILIES = 9
SMALLEST_N = 20


def families_of(rated):
    """Random ones first, then those on which some heuristic is furthest from the optimum."""
    sizes = rated.groupby("family")["n"].nunique()
    usable = list(sizes[sizes > 2].index)
    worst = rated.groupby("family")["alpha_upper"].max().sort_values(ascending=False)
    random = [family for family in RANDOM_FAMILIES if family in usable]
    return (random + [family for family in worst.index if family in usable and family not in random])[:MOST_FAMILIES]


def draw_family(axes, cells, labels, styles):
    axes.axhspan(0.1, 0.5, color="#888888", alpha=0.16, linewidth=0)
    for label in labels:
        of_label = cells[cells["label"] == label].groupby("n")["alpha_upper"]
        mean = (of_label.mean() - 1).clip(lower=LOWEST_EXCESS)
        largest = (of_label.max() - 1).clip(lower=LOWEST_EXCESS)
        axes.vlines(mean.index, mean, largest, color=styles.colour(label), linewidth=0.9)
        axes.plot(mean.index, mean, label=label, clip_on=False, **styles[label])
    axes.set_xscale("log")
    axes.set_yscale("log")


def set_common_scale(all_axes):
    """The same decades for every panel; the lowest stands for optimal."""
    highest = max(axes.dataLim.y1 for axes in all_axes)
    decades = range(round(math.log10(LOWEST_EXCESS)), math.ceil(math.log10(highest)) + 1)
    ticks = [10.0**decade for decade in decades]
    texts = ["optimal"] + [f"{100 * tick:,g} %" for tick in ticks[1:]]
    for axes in all_axes:
        axes.set_ylim(LOWEST_EXCESS, ticks[-1])
        axes.set_yticks(ticks, texts)
        axes.minorticks_off()


def draw(results, families=None):
    rated = results.rated[results.rated["n"] >= SMALLEST_N]
    families = families or families_of(rated)
    present = set(rated["label"])
    labels = [label for label in report_first(present) if label in SHOWN]
    if not families or not labels:
        return None
    styles = Styles(labels)
    columns = min(3, len(families))
    rows = -(-len(families) // columns)
    figure, grid = plt.subplots(
        rows, columns, figsize=(3.0 * columns + 0.4, 2.3 * rows + 0.6), squeeze=False, sharex=True
    )
    panels = list(grid.flat)
    for axes, family in zip(panels, families):
        axes.tick_params(labelbottom=True)
        draw_family(axes, rated[rated["family"] == family], labels, styles)
        axes.set_title(family)
        axes.set_xlabel("points n")
    set_common_scale(panels[: len(families)])
    for axes in panels[len(families) :]:
        axes.set_visible(False)
    panels[0].annotate(
        "the report's band",
        (1, 0.22),
        xycoords=("axes fraction", "data"),
        fontsize=7.5,
        color=INK,
        ha="right",
        va="center",
    )
    for axes in grid[:, 0]:
        axes.set_ylabel(r"excess $\alpha - 1$")
    legend_below(figure, *panels[0].get_legend_handles_labels())
    return figure
