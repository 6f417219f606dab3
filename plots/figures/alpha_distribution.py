"""How alpha is distributed over instances: one row per algorithm, every instance a mark."""
import matplotlib.pyplot as plt
import numpy as np

from library.records import RANDOM_FAMILIES
from library.style import INK, Styles, report_first

TITLE = "Which algorithm does “1.1–1.5” fit?"
CAPTION = (
    "Every mark is one random instance (uniform, normal or clustered, n ≥ 20) against its proved optimum; the tick is"
    " the median. The shaded band is what the report says of greedy: greedy never comes near it, hull insertion leaves"
    " it upwards."
)
HEURISTICS = (
    "hull_insertion",
    "sweep",
    "quadtree",
    "delaunay",
    "flip_report",
    "flip",
    "greedy_report",
    "greedy",
    "annealing",
    "patch",
)
LOWEST_EXCESS = 1e-6
SMALLEST_N = 20


def row_positions(count, seed):
    """Offsets that keep marks apart, the same every time."""
    return np.random.default_rng(seed).uniform(-0.28, 0.28, count)


def draw(results):
    rated = results.rated
    rated = rated[rated["family"].isin(RANDOM_FAMILIES) & (rated["n"] >= SMALLEST_N)]
    labels = [label for label in report_first(set(rated["label"])) if label in HEURISTICS]
    if not labels:
        return None
    styles = Styles(labels)
    figure, axes = plt.subplots(figsize=(9, 0.42 * len(labels) + 1.1))
    axes.axvspan(0.1, 0.5, color="#888888", alpha=0.16, linewidth=0)
    for row, label in enumerate(labels):
        excess = (rated[rated["label"] == label]["alpha_upper"] - 1).clip(lower=LOWEST_EXCESS)
        axes.scatter(
            excess, row + row_positions(len(excess), row), s=9, color=styles.colour(label), alpha=0.55, linewidth=0
        )
        axes.plot([excess.median()] * 2, [row - 0.4, row + 0.4], color=INK, linewidth=2)
    axes.set_xscale("log")
    decades = range(-6, int(np.ceil(np.log10(rated["alpha_upper"].max()))) + 1)
    axes.set_xticks([10.0**d for d in decades], ["optimal"] + [f"{100 * 10.0**d:,g} %" for d in decades[1:]])
    axes.minorticks_off()
    axes.set_yticks(range(len(labels)), labels)
    axes.set_ylim(len(labels) - 0.4, -1.1)
    axes.text(0.22, -0.6, "the report on greedy", ha="center", va="center", fontsize=7.5)
    axes.grid(axis="y", visible=False)
    axes.set_xlabel(r"excess over the optimum, $\alpha - 1$")
    figure.tight_layout()
    return figure
