"""By how much the algorithms exceed the optimum, alpha - 1 by n, one panel per family: those that readers look for first."""
import math

from figures.panels import (
    always_optimal,
    equal_labels,
    grid,
    large_enough,
    legend,
    name_panel,
    percent_ticks,
    side_by_side,
)
from library.records import OPTIMAL
from library.style import INK, Styles

TITLE = "How far from the optimum, by n"
MOST_FAMILIES = 9
LOWEST_DECADE = -5
REPORTS_BAND = (0.1, 0.5)


class Chosen:
    """What is drawn: families with several sizes, algorithms that are not always optimal, of equal ones the first."""

    def __init__(self, results, further):
        observations = large_enough(results.observations)
        sizes = observations.groupby("family")["n"].nunique()
        worst = observations.groupby("family")["alpha_upper"].max()
        several = [family for family in results.families if sizes.get(family, 0) > 1]
        shown = [family for family in several if worst[family] > OPTIMAL]
        self.trivial = [family for family in several if worst[family] <= OPTIMAL]
        self.families = shown[MOST_FAMILIES:] if further else shown[:MOST_FAMILIES]
        self.observations = observations[observations["family"].isin(self.families)]
        cells = large_enough(results.rated_cells)
        self.cells = cells[cells["family"].isin(self.families)]
        self.optimal = always_optimal(self.observations)
        present = set(self.observations["label"])
        self.labels = [label for label in results.labels if label in present - self.optimal]
        self.equal = equal_labels(self.observations, self.labels)


def draw_family(axes, cells, chosen, styles):
    lowest = 10.0**LOWEST_DECADE
    excess = (cells.set_index(["label", "n"])[["alpha_mean", "alpha_max"]] - 1).clip(lower=lowest).sort_index()
    excess.columns = ["mean", "max"]
    labels = [label for label in chosen.equal if label in excess.index]
    places = iter(side_by_side(axes, [mark for label in labels for mark in excess.loc[label]["mean"].items()]))
    for label in labels:
        own = excess.loc[label]
        xs = [next(places)[0] for _ in own.index]
        look = styles[label]
        axes.plot(own.index, own["mean"], color=look["color"], linestyle=look["linestyle"], linewidth=0.9)
        axes.vlines(xs, own["mean"], own["max"], color=look["color"], linewidth=0.9)
        name = " = ".join([label, *chosen.equal[label]])
        axes.plot(xs, own["mean"], label=name, clip_on=False, **styles.mark(label))


def set_scale(axes, observations, highest):
    """The same decades for every panel; the lowest stands for optimal."""
    ticks, texts = percent_ticks(LOWEST_DECADE, highest)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(observations["n"].min() / 1.4, observations["n"].max() * 1.4)
    axes.set_ylim(ticks[0], ticks[-1])
    axes.set_yticks(ticks, texts)
    axes.minorticks_off()


def draw_band(axes, has_name):
    axes.axhspan(*REPORTS_BAND, color="#888888", alpha=0.16, linewidth=0)
    if has_name:
        axes.annotate(
            "source report",
            (1, 0.22),
            xycoords=("axes fraction", "data"),
            fontsize=7.5,
            color=INK,
            ha="right",
            va="center",
        )


def draw(results, layout, further=False):
    chosen = Chosen(results, further)
    if not chosen.labels:
        return None
    styles = Styles(chosen.labels)
    figure, panels = grid(len(chosen.families), layout, 2.4)
    highest = max(0, math.ceil(math.log10(chosen.observations["alpha_upper"].max() - 1)))
    for position, (axes, family) in enumerate(zip(panels, chosen.families)):
        set_scale(axes, chosen.observations, highest)
        name_panel(axes, family, layout)
        axes.set_xlabel("points n")
        if position % layout.columns == 0:
            axes.set_ylabel(r"excess $\alpha - 1$")
    figure.tight_layout()
    for position, (axes, family) in enumerate(zip(panels, chosen.families)):
        if results.judges_claims:
            draw_band(axes, position == 0)
        draw_family(axes, chosen.cells[chosen.cells["family"] == family], chosen, styles)
    legend(figure, panels, layout)
    return figure


def names(labels, chosen):
    return ", ".join(label for label in labels if label in chosen)


def caption(results, further=False):
    chosen = Chosen(results, further)
    sentences = [
        "A mark is the mean over instances of α − 1, a bar reaches to the largest; both axes are logarithmic. Marks that"
        " would hide each other stand side by side."
    ]
    if further:
        sentences.append("These are the families on which α stays lower.")
    else:
        sentences.append(
            "Every optimum is proved: its certified interval is narrower than a millionth of a point on this page. Values"
            " below the axis’s lowest decade lie on the line “optimal”."
        )
    if results.judges_claims:
        sentences.append("The shaded band is the source report’s range for greedy, 1.1–1.5.")
    if any(chosen.equal.values()):
        sentences.append("Names joined by “=” have the same α wherever both ran.")
    if chosen.optimal:
        sentences.append(f"Optimal on every instance here, and not drawn: {names(results.labels, chosen.optimal)}.")
    if chosen.trivial and further:
        sentences.append(f"Every algorithm is optimal on {names(results.families, chosen.trivial)}.")
    return " ".join(sentences)
