"""How alpha is distributed over instances: one row per algorithm, every instance a mark."""
import math

import matplotlib.pyplot as plt
import numpy as np

from figures.panels import always_optimal, fold, large_enough, percent_ticks
from library.html_page import counted
from library.records import USUAL_FAMILIES
from library.style import INK, Styles

LOWEST_DECADE = -6
REPORTS_BAND = (0.1, 0.5)
MOST_SHAPES = 5000  # more marks are a picture within the figure, so that a page of 100,000 runs opens quickly


def observations_of(results):
    """The claim is about random points; another study shows all that it has."""
    observations = results.observations
    if results.judges_claims:
        observations = observations[observations["family"].isin(USUAL_FAMILIES)]
    return large_enough(observations)


def drawn_labels(results, observations):
    present = set(observations["label"]) - always_optimal(observations)
    return [label for label in results.labels if label in present]


def row_positions(count, seed):
    """Offsets within [-1, 1] that keep marks apart, the same every time."""
    return np.random.default_rng(seed).uniform(-1, 1, count)


def described(label, of_label):
    """The name of a row, with the sizes that its marks stand for."""
    low, high = of_label["n"].min(), of_label["n"].max()
    sizes = f"n = {low:,}" if low == high else f"n = {low:,} to {high:,}"
    return f"{label}\n{sizes}: {counted(len(of_label), 'instance')}"


def draw_row(axes, row, of_label, colour, half, as_picture):
    """`half` of its height, of the 1 that a row has."""
    excess = (of_label["alpha_upper"] - 1).clip(lower=10.0**LOWEST_DECADE)
    heights = row + 0.7 * half * row_positions(len(excess), row)
    axes.scatter(excess, heights, s=9, color=colour, alpha=0.55, linewidth=0, rasterized=as_picture)
    axes.plot([excess.median()] * 2, [row - half, row + half], color=INK, linewidth=2)


def name_rows(axes, names, layout):
    """Beside the rows; on a narrow page above them."""
    axes.set_yticks(range(len(names)), [] if layout.is_narrow else names, fontsize=7.5)
    axes.grid(axis="y", visible=False)
    axes.tick_params(axis="y", length=0)
    if layout.is_narrow:
        for row, name in enumerate(names):
            text = fold(name.replace("\n", ", "), layout.panel_width + 0.2, 7)
            axes.text(0.01, row - 0.34, text, fontsize=7, linespacing=1, transform=axes.get_yaxis_transform())


def draw_band(axes):
    axes.axvspan(*REPORTS_BAND, color="#888888", alpha=0.16, linewidth=0)
    axes.text(0.22, -0.85, "source report: greedy", ha="center", va="center", fontsize=7.5)


def draw(results, layout):
    observations = observations_of(results)
    labels = drawn_labels(results, observations)
    if not labels:
        return None
    styles = Styles(labels)
    row_height = 0.68 if layout.is_narrow else 0.42
    figure, axes = plt.subplots(figsize=(layout.width(layout.columns), row_height * len(labels) + 1.1))
    if results.judges_claims:
        draw_band(axes)
    names = []
    for row, label in enumerate(labels):
        of_label = observations[observations["label"] == label]
        half = 0.27 if layout.is_narrow else 0.4
        draw_row(axes, row, of_label, styles.colour(label), half, len(observations) > MOST_SHAPES)
        names.append(described(label, of_label))
    name_rows(axes, names, layout)
    axes.set_ylim(len(labels) - 0.4, -1.2 if results.judges_claims or layout.is_narrow else -0.7)
    highest = max(0, math.ceil(math.log10(observations["alpha_upper"].max() - 1)))
    ticks, texts = percent_ticks(LOWEST_DECADE, highest)
    every = 2 if layout.is_narrow else 1
    axes.set_xscale("log")
    axes.set_xticks(ticks[::every], texts[::every])
    axes.minorticks_off()
    axes.set_xlabel(r"excess over the optimum, $\alpha - 1$")
    figure.tight_layout()
    return figure


def title(results):
    return "Which algorithm does “1.1–1.5” fit?" if results.judges_claims else "How far from the optimum, every instance"


def caption(results):
    observations = observations_of(results)
    families = "random instance (uniform, normal or clustered)" if results.judges_claims else "instance"
    sentences = [
        f"Every mark is one {families} relative to its proved optimum, the median over repetitions; the tick is the median"
        " of the row. Rows whose sizes differ, as stated beside them, are not comparable by their medians."
    ]
    if results.judges_claims:
        sentences.append("The shaded band is the range that the source report states for greedy.")
    optimal = always_optimal(observations)
    if optimal:
        sentences.append(f"Optimal on every instance: {', '.join(label for label in results.labels if label in optimal)}.")
    return " ".join(sentences)
