"""Families built against a heuristic: how alpha grows with n there."""
import matplotlib.pyplot as plt
import numpy as np

from figures.fits import power_law
from library.style import FAINT, INK, Styles, report_first

TITLE = "Where heuristics fail: growth of α"
CAPTION = (
    "α against n, both logarithmic, with the fitted slope e: α grows like n to the power e. Random points make every"
    " heuristic look good; on families built against one there is no bound. Drawn are the lower ends of the certified"
    " intervals for α, of the pairs whose slope exceeds {smallest}. The dotted line is log n, scaled: what the report"
    " promises of hull insertion."
)
SMALLEST_SLOPE = 0.1
SMALLEST_N = 20
MOST_FAMILIES = 9
MOST_ALIKE = 3  # panels that show the same algorithms
BASELINES = ("sweep",)  # never meant to be short


def series(runs):
    """{family: {label: (alpha by n, exponent, factor)}} of what grows, the steepest families first."""
    found = {}
    runs = runs[
        (runs["status"] == "ok") & (runs["stopped_early"] == 0) & (runs["alpha_lower"] >= 1) & (runs["n"] >= SMALLEST_N)
    ]
    for (family, label), cell in runs[runs["generator"] != "file"].groupby(["family", "label"]):
        alpha = cell.groupby("n")["alpha_lower"].mean()
        if len(alpha) < 3 or label in BASELINES:
            continue
        exponent, factor = power_law(alpha.index.to_numpy(float), alpha.to_numpy())
        if exponent > SMALLEST_SLOPE:
            found.setdefault(family, {})[label] = (alpha, exponent, factor)
    return dict(sorted(found.items(), key=lambda item: -max(exponent for _, exponent, _ in item[1].values())))


def chosen(growing):
    """The steepest families, not too many of a kind."""
    shown, alike = {}, {}
    for family, of_family in growing.items():
        kind = tuple(sorted(of_family))
        alike[kind] = alike.get(kind, 0) + 1
        if alike[kind] <= MOST_ALIKE and len(shown) < MOST_FAMILIES:
            shown[family] = of_family
    return shown


def draw_family(axes, of_family, styles):
    for label in report_first(of_family):
        alpha, exponent, factor = of_family[label]
        n = alpha.index.to_numpy(float)
        axes.plot(n, alpha, label=f"{label}  e = {exponent:.2f}", **dict(styles[label], linestyle=""))
        ends = np.array([SMALLEST_N, n[-1]])
        axes.plot(ends, factor * ends**exponent, color=styles.colour(label), linewidth=1.1)
    n = np.geomspace(SMALLEST_N, max(alpha.index.max() for alpha, _, _ in of_family.values()), 40)
    axes.plot(n, np.log(n) / np.log(SMALLEST_N), color=INK, linewidth=0.7, linestyle=":", zorder=1)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.minorticks_off()
    top = axes.get_ylim()[1]
    axes.set_ylim(0.9, top ** (1 + 0.12 * len(of_family) + 0.1))  # room for the legend
    ticks = [tick for tick in (1, 2, 5, 10, 20, 50, 100, 1000, 1e4) if tick <= top * 1.2]
    axes.set_yticks(ticks, [f"{tick:,g}" for tick in ticks])
    axes.legend(fontsize=7, loc="upper left", handletextpad=0.2, labelspacing=0.25, borderaxespad=0)


def draw(results):
    growing = chosen(series(results.runs))
    if not growing:
        return None
    styles = Styles(report_first({label for of_family in growing.values() for label in of_family}))
    columns = min(3, len(growing))
    rows = -(-len(growing) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(3.0 * columns + 0.4, 2.5 * rows + 0.2), squeeze=False)
    panels = list(grid.flat)
    for axes, (family, of_family) in zip(panels, growing.items()):
        draw_family(axes, of_family, styles)
        axes.set_title(family)
        axes.set_xlabel("points n")
    for axes in panels[len(growing) :]:
        axes.set_visible(False)
    for axes in grid[:, 0]:
        axes.set_ylabel(r"$\alpha$")
    figure.tight_layout()
    return figure


def caption(results):
    return CAPTION.format(smallest=SMALLEST_SLOPE)
