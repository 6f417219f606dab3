"""Families built against a heuristic: how alpha grows with n there."""
import numpy as np

from figures.panels import coincident, fold, grid, name_panel, side_by_side
from library.style import INK, Styles, report_first

TITLE = "Where heuristics fail: growth of α"
SMALLEST_SLOPE = 0.1
LEGEND_SIZE = 7
MOST_FAMILIES = 9
MOST_ALIKE = 3  # panels that show the same algorithms
TICKS = (1, 2, 5, 10, 20, 50, 100, 1000, 1e4, 1e5)


def laws(results):
    """{family: {label: (alpha by n, law)}} of whatever `mwt report` fitted a power law to."""
    cells = results.summary
    cells = cells[(cells["rated_instances"] > 0) & (cells["generator"] != "file")]
    found = {}
    for (family, label), of_series in cells.groupby(["family", "label"]):
        law = results.laws.get((family, label, "alpha"))
        if law:
            found.setdefault(family, {})[label] = (of_series.set_index("n")["alpha_mean"], law)
    return found


def usual_exponents(found):
    """The median over the families of each label's exponent; 0 where there are too few families to say what is usual."""
    exponents = {}
    for of_family in found.values():
        for label, (_, law) in of_family.items():
            exponents.setdefault(label, []).append(law.exponent)
    return {label: np.median(own) if len(found) > 3 else 0 for label, own in exponents.items()}


def chosen(results):
    """What grows on the families on which something grows faster than it usually does; not too many families of a kind."""
    found = laws(results)
    usual = usual_exponents(found)
    growing = {
        family: {label: (alpha, law) for label, (alpha, law) in of_family.items() if law.exponent > SMALLEST_SLOPE}
        for family, of_family in found.items()
    }

    def faster(family):
        """{label: by how much more its exponent is here}."""
        differences = {label: law.exponent - usual[label] for label, (_, law) in growing[family].items()}
        return {label: more for label, more in differences.items() if more > SMALLEST_SLOPE}

    remarkable = [family for family in growing if faster(family)]
    shown, alike = {}, {}
    for family in sorted(remarkable, key=lambda family: -max(faster(family).values())):
        kind = tuple(sorted(faster(family)))
        alike[kind] = alike.get(kind, 0) + 1
        if alike[kind] <= MOST_ALIKE and len(shown) < MOST_FAMILIES:
            shown[family] = growing[family]
    return shown


def line(law):
    """The ends of the fitted line: over the sizes that it is fitted to, and only where it is at least 1, as alpha is."""
    ends = np.array([max(law.min_n, law.factor ** (-1 / law.exponent)), law.max_n])
    return ends, law.at(ends)


def set_scale(axes, of_family):
    max_n = max(law.max_n for _, law in of_family.values())
    min_n = min(law.min_n for _, law in of_family.values())
    top = max(alpha.max() for alpha, _ in of_family.values())
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(min_n / 1.4, max_n * 1.4)
    axes.set_ylim(0.9, max(top, 1.5) ** (1 + 0.12 * len(of_family) + 0.1))  # room for the legend
    ticks = [tick for tick in TICKS if tick <= top * 1.2]
    axes.set_yticks(ticks, [f"{tick:,g}" for tick in ticks])
    axes.minorticks_off()


def exponent_text(law):
    """In one piece, which no line of a legend breaks."""
    return f" e {'=' if law.fits else '≈'} {law.exponent:.2f}{law.interval()}".replace(" ", "\u00a0")


def draw_family(axes, of_family, styles, inches):
    equal = coincident({label: [*of_family[label][0].index, *of_family[label][0]] for label in report_first(of_family)})
    labels = list(equal)
    marks = [(n, value) for label in labels for n, value in of_family[label][0].items()]
    places = iter(side_by_side(axes, marks))
    for label in labels:
        alpha, law = of_family[label]
        axes.plot(*line(law), color=styles.colour(label), linewidth=1.1, linestyle=law.line_style)
        own = [next(places) for _ in alpha]
        name = fold(f"{' = '.join([label, *equal[label]])} {exponent_text(law)}", inches, LEGEND_SIZE)
        axes.plot(*zip(*own), label=name, **styles.mark(label))
    n = np.geomspace(*axes.get_xlim(), 40)
    axes.plot(n, np.log(n) / np.log(n[0]), color=INK, linewidth=0.7, linestyle=":", zorder=1)
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
    promise = ": the growth that the source report states for hull insertion" if results.judges_claims else ""
    return (
        "α against n, both logarithmic. A mark is the mean α over the instances with a proved optimum; marks that would hide"
        " each other stand side by side, and names joined by “=” have the same α at every n. A line is the power law that mwt report fitted to all sizes (exponents.csv): α grows"
        " like n to the power e, with the 95% interval in parentheses. A dashed line (≈) is the mean slope where the values do"
        " not follow a power law. Lines end where they would fall below 1, the least α. The figure shows families on which an"
        " algorithm’s exponent is larger than on most families, and there the algorithms whose exponent exceeds"
        f" {SMALLEST_SLOPE}. The dotted line is log n, scaled{promise}."
    )
