"""Running times by n with fitted lines."""
import numpy as np
from matplotlib.transforms import ScaledTranslation

from figures.panels import coincident, fold, grid, set_time_ticks
from library.style import Styles, legend_columns, name_of

TITLE = "Running time by n"
REPORTS = ("brute_force", "greedy_naive", "hull_insertion", "flip_naive", "quadtree", "delaunay")
IN_BOTH = ("delaunay",)  # to compare with
SMALLEST_SPAN = 4  # of the sizes; over fewer, a power law and an exponential one look alike
LEGEND_SIZE = 7.5
LEGEND_ROW = 0.2  # inches: a power is higher than text


def medians(results):
    """{family: {label: median over instances by n}} of summary.csv, the families in their order."""
    cells = results.cells[results.cells["wall_time_median_s"].notna()].sort_values("n")
    found = {family: {} for family in results.families}
    for (family, label), of_series in cells.groupby(["family", "label"]):
        found[family][label] = of_series.set_index("n")["wall_time_median_s"]
    return found


def number_of_sizes(times):
    return sum(len(of_label) for of_label in times.values() if len(of_label) > 1)


def times_of(results):
    """The first family on which many algorithms ran at many sizes, and {name: (median by n, law)}: of the algorithms on that
    family, and of those that do not take it on the family on which they ran at most sizes, which their name then states."""
    found = medians(results)
    largest = max(map(number_of_sizes, found.values()), default=0)
    if largest == 0:
        return None, {}
    family = next(family for family in found if 2 * number_of_sizes(found[family]) >= largest)
    times = {}
    for label in results.labels:
        other = max(found, key=lambda other: len(found[other].get(label, ())))
        if label in found[family]:
            times[label] = found[family][label], law_of(results, family, label)
        elif len(found[other].get(label, ())) > 1:
            times[f"{label} on {other}"] = found[other][label], law_of(results, other, label)
    return family, times


def joined(times):
    """The same with one entry, "a = b", for those whose times are all equal: they would hide each other."""
    equal = coincident({label: [*of_label.index, *of_label] for label, (of_label, _) in times.items()})
    return {" = ".join([label, *others]): times[label] for label, others in equal.items()}


def law_of(results, family, label):
    """None over so small a range of sizes that everything looks like a power law."""
    law = results.laws.get((family, label, "wall_time_s"))
    return law if law and law.max_n >= SMALLEST_SPAN * law.min_n else None


def panels_of(results, labels):
    """{title: labels}: the source report's algorithms beside all others where the study judges its claims."""
    if not results.judges_claims:
        return {"": labels}
    reports = [label for label in labels if name_of(label) in REPORTS]
    others = [label for label in labels if name_of(label) not in REPORTS or name_of(label) in IN_BOTH]
    panels = {"as the source report writes them": reports, "fast, exact and others": others}
    return {title: labels for title, labels in panels.items() if labels}


def exponent_text(law):
    return f"  {'' if law.fits else '≈ '}$n^{{{law.exponent:.2f}}}${law.interval()}" if law else ""


def draw_panel(axes, times, styles, inches):
    for label, (of_label, law) in times.items():
        if law:
            ends = np.array([law.min_n, law.max_n], float)
            axes.plot(ends, law.at(ends), color=styles.colour(label), linewidth=1.1, linestyle=law.line_style)
        axes.plot(of_label.index, of_label, label=legend_name(label, law, inches), **styles.mark(label))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("points n")
    axes.minorticks_off()


def legend_name(label, law, inches):
    """The label with the exponent, which is not broken."""
    name, exponent = fold(label, inches, LEGEND_SIZE), exponent_text(law)
    widest = max(map(len, name.split("\n"))) + len(exponent) - len("$^{}$")
    is_wide = exponent and widest > 110 / LEGEND_SIZE * (inches + 0.7)
    return f"{name}\n{exponent}" if is_wide else name + exponent


def legend_rows(times, inches):
    """(columns, rows) of a legend below a panel."""
    names = [legend_name(label, law, inches - 0.7) for label, (_, law) in times.items()]
    columns = min(4, legend_columns(inches, [name.replace("$", "") for name in names], LEGEND_SIZE))
    return columns, -(-len(names) // columns) + sum(name.count("\n") for name in names)


def draw(results, layout):
    _, times = times_of(results)
    if not times:
        return None
    times = joined(times)
    panels = panels_of(results, list(times))
    layout = layout.divided(len(panels))
    legends = [
        legend_rows({label: times[label] for label in labels}, layout.panel_width - 0.4) for labels in panels.values()
    ]
    height = 3.4 + LEGEND_ROW * max(rows for _, rows in legends)
    figure, all_axes = grid(len(panels), layout, height, sharey=True)
    for axes, (title, labels), (of_legend, _) in zip(all_axes, panels.items(), legends):
        draw_panel(axes, {label: times[label] for label in labels}, Styles(labels), layout.panel_width - 1.1)
        axes.set_title(title)
        axes.legend(
            fontsize=LEGEND_SIZE,
            loc="upper left",
            bbox_to_anchor=(0, 0),
            bbox_transform=axes.transAxes + ScaledTranslation(-0.1, -0.4, figure.dpi_scale_trans),  # below "points n"
            ncol=of_legend,
            handletextpad=0.2,
            columnspacing=0.8,
        )
    for axes in all_axes[:: layout.columns]:
        set_time_ticks(axes.yaxis)
        axes.set_ylabel("wall time")
    figure.tight_layout()
    return figure


def caption(results):
    family, times = times_of(results)
    sentences = [
        f"Median wall time of the algorithm alone, on {family} unless the legend names another family. A solid line is the"
        " power law that mwt report fitted to the times of all sizes (exponents.csv); the legend states its exponent with the"
        " 95% interval. Sizes that span less than a factor"
        f" of {SMALLEST_SPAN} have no line, nor do series with a run that stopped early."
    ]
    if any(law and not law.fits for _, law in times.values()):
        sentences.append("A dashed line (≈) is the mean slope where the times do not follow a power law.")
    if results.judges_claims:
        sentences.append("The algorithms as the source report writes them have a panel of their own.")
    return " ".join(sentences)
