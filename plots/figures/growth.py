"""Families built against a heuristic: how alpha grows with n there."""
import numpy as np

from figures.fits import power_law, upper_half
from figures.panels import SMALLEST_N, fold, grid, name_panel, side_by_side
from library.records import CELL
from library.style import INK, Styles, report_first

TITLE = "Where heuristics fail: growth of α"
SMALLEST_SLOPE = 0.1
LEGEND_SIZE = 7
MOST_FAMILIES = 9
MOST_ALIKE = 3  # panels that show the same algorithms
TICKS = (1, 2, 5, 10, 20, 50, 100, 1000, 1e4, 1e5)


def laws(results):
    """{family: {label: (alpha by n, exponent, factor)}} of whatever has three sizes."""
    found = {}
    runs = results.finished
    runs = runs[(runs["alpha_lower"] >= 1) & (runs["n"] >= SMALLEST_N) & (runs["generator"] != "file")]
    by_instance = runs.groupby([*CELL, "instance_id"])["alpha_lower"].median()
    means = by_instance.groupby(CELL).mean().reset_index("n")
    for (family, label), cell in means.groupby(["family", "label"]):
        alpha = cell.set_index("n")["alpha_lower"]
        if len(alpha) > 2:
            upper = upper_half(alpha)
            law = power_law(upper.index.to_numpy(float), upper.to_numpy())
            found.setdefault(family, {})[label] = (alpha, *law)
    return found


def usual_exponents(found):
    """The median over the families of each label's exponent; 0 where there are too few families to say what is usual."""
    exponents = {}
    for of_family in found.values():
        for label, (_, exponent, _) in of_family.items():
            exponents.setdefault(label, []).append(exponent)
    return {label: np.median(own) if len(found) > 3 else 0 for label, own in exponents.items()}


def chosen(results):
    """What grows on the families on which something grows faster than it usually does; not too many families of a kind."""
    found = laws(results)
    usual = usual_exponents(found)
    growing = {
        family: {label: law for label, law in of_family.items() if law[1] > SMALLEST_SLOPE}
        for family, of_family in found.items()
    }

    def faster(family):
        """{label: by how much more its exponent is here}."""
        differences = {label: exponent - usual[label] for label, (_, exponent, _) in growing[family].items()}
        return {label: more for label, more in differences.items() if more > SMALLEST_SLOPE}

    remarkable = [family for family in growing if faster(family)]
    shown, alike = {}, {}
    for family in sorted(remarkable, key=lambda family: -max(faster(family).values())):
        kind = tuple(sorted(faster(family)))
        alike[kind] = alike.get(kind, 0) + 1
        if alike[kind] <= MOST_ALIKE and len(shown) < MOST_FAMILIES:
            shown[family] = growing[family]
    return shown


def line(alpha, exponent, factor):
    """The ends of the fitted line: over the sizes that it is fitted to, and only where it is at least 1, as alpha is."""
    first, last = float(upper_half(alpha).index[0]), float(alpha.index[-1])
    ends = np.array([max(first, factor ** (-1 / exponent)), last])
    return ends, factor * ends**exponent


def set_scale(axes, of_family):
    max_n = max(alpha.index.max() for alpha, _, _ in of_family.values())
    top = max(alpha.max() for alpha, _, _ in of_family.values())
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(SMALLEST_N / 1.4, max_n * 1.4)
    axes.set_ylim(0.9, max(top, 1.5) ** (1 + 0.12 * len(of_family) + 0.1))  # room for the legend
    ticks = [tick for tick in TICKS if tick <= top * 1.2]
    axes.set_yticks(ticks, [f"{tick:,g}" for tick in ticks])
    axes.minorticks_off()


def draw_family(axes, of_family, styles, inches):
    labels = report_first(of_family)
    marks = [(n, value) for label in labels for n, value in of_family[label][0].items()]
    places = iter(side_by_side(axes, marks))
    for label in labels:
        alpha, exponent, factor = of_family[label]
        axes.plot(*line(alpha, exponent, factor), color=styles.colour(label), linewidth=1.1)
        own = [next(places) for _ in alpha]
        name = fold(f"{label}  e = {exponent:.2f}", inches, LEGEND_SIZE)
        axes.plot(*zip(*own), label=name, **styles.mark(label))
    n = np.geomspace(SMALLEST_N, max(alpha.index.max() for alpha, _, _ in of_family.values()), 40)
    axes.plot(n, np.log(n) / np.log(SMALLEST_N), color=INK, linewidth=0.7, linestyle=":", zorder=1)
    axes.legend(fontsize=LEGEND_SIZE, loc="upper left", handletextpad=0.2, labelspacing=0.25, borderaxespad=0)


def draw(results, layout):
    growing = chosen(results)
    if not growing:
        return None
    styles = Styles(report_first({label for of_family in growing.values() for label in of_family}))
    figure, panels = grid(len(growing), layout, 2.5)
    for position, (axes, (family, of_family)) in enumerate(zip(panels, growing.items())):
        set_scale(axes, of_family)
        name_panel(axes, family, layout)
        axes.set_xlabel("points n")
        if position % layout.columns == 0:
            axes.set_ylabel(r"$\alpha$")
    figure.tight_layout()
    for axes, of_family in zip(panels, growing.values()):
        draw_family(axes, of_family, styles, layout.panel_width - 1)
    return figure


def caption(results):
    promise = ": what the report promises of hull insertion" if results.judges_claims else ""
    return (
        "α against n, both logarithmic, with the fitted slope e: α grows like n to the power e. A line spans the sizes that"
        " it is fitted to, of more than five the larger half, and stops where it would fall below 1, which no α does. Shown"
        " are families on which an algorithm grows faster than on most: on random points every heuristic looks good, on"
        " points built against it there is no bound. A mark is the mean over instances of the lower ends of the certified"
        f" intervals for α, of the algorithms whose slope exceeds {SMALLEST_SLOPE}; marks that would hide each other stand"
        f" side by side. The dotted line is log n, scaled{promise}."
    )
