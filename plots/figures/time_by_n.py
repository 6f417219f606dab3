"""Running times by n with fitted lines."""
import numpy as np

from figures.fits import is_exponential, power_law, upper_half
from figures.panels import fold, grid, set_time_ticks
from library.records import CELL
from library.style import Styles, legend_columns, name_of

TITLE = "Running time by n"
REPORTS = ("brute_force", "greedy_naive", "hull_insertion", "flip_naive", "quadtree", "delaunay")
IN_BOTH = ("delaunay",)  # to compare with
SMALLEST_FITTED_TIME_S = 2e-5
SMALLEST_SPAN = 4  # of the sizes; over fewer, a power law and an exponential one look alike
LEGEND_SIZE = 7.5

def medians(results):
    """{family: {label: median over instances by n}}, the families in their order."""
    runs = results.finished[results.finished["wall_time_s"].notna()]
    by_instance = runs.groupby([*CELL, "instance_id"])["wall_time_s"].median()
    by_cell = by_instance.groupby(CELL).median()
    found = {family: {} for family in results.families}
    for (family, label), times in by_cell.groupby(level=["family", "label"]):
        found[family][label] = times.droplevel(["family", "label"])
    return found


def number_of_sizes(times):
    return sum(len(of_label) for of_label in times.values() if len(of_label) > 1)


def times_of(results):
    """The first family on which many algorithms ran at many sizes, and {name: median by n}: of the algorithms on that family,
    and of those that do not take it on the family on which they ran at most sizes, which their name says then."""
    found = medians(results)
    largest = max(map(number_of_sizes, found.values()), default=0)
    if largest == 0:
        return None, {}
    family = next(family for family in found if 2 * number_of_sizes(found[family]) >= largest)
    times = {}
    for label in results.labels:
        other = max(found, key=lambda other: len(found[other].get(label, ())))
        if label in found[family]:
            times[label] = found[family][label]
        elif len(found[other].get(label, ())) > 1:
            times[f"{label} on {other}"] = found[other][label]
    return family, times


def panels_of(results, labels):
    """{title: labels}: the report's algorithms beside all others where the study is about the report."""
    if not results.judges_claims:
        return {"": labels}
    reports = [label for label in labels if name_of(label) in REPORTS]
    others = [label for label in labels if name_of(label) not in REPORTS or name_of(label) in IN_BOTH]
    panels = {"as the report writes them": reports, "fast, exact and others": others}
    return {title: labels for title, labels in panels.items() if labels}


def grows_exponentially(times):
    times = times[times > SMALLEST_FITTED_TIME_S]
    return is_exponential(times.index.to_numpy(float), times.to_numpy())


def fitted(times):
    """The slope over the upper half of the sizes, which small costs disturb least; None if there are too few or if times
    grow exponentially."""
    times = times[times > SMALLEST_FITTED_TIME_S]
    if times.empty or times.index[-1] < SMALLEST_SPAN * times.index[0] or grows_exponentially(times):
        return None
    upper = upper_half(times)
    return power_law(upper.index.to_numpy(float), upper.to_numpy()) + (upper.index,) if len(upper) > 2 else None


def draw_panel(axes, times, styles, inches):
    for label, of_label in times.items():
        fit = fitted(of_label)
        name = fold(label, inches, LEGEND_SIZE)
        if fit:
            exponent, factor, sizes = fit
            ends = np.array([sizes[0], sizes[-1]], float)
            axes.plot(ends, factor * ends**exponent, color=styles.colour(label), linewidth=1.1)
            name += f"  $n^{{{exponent:.2f}}}$"
        axes.plot(of_label.index, of_label, label=name, **styles.mark(label))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("points n")
    axes.minorticks_off()


def legend_rows(labels, inches):
    """(columns, rows) of a legend below a panel."""
    names = [fold(label, inches - 0.7, LEGEND_SIZE) for label in labels]
    columns = min(4, legend_columns(inches, [f"{name}  n1.23" for name in names], LEGEND_SIZE))
    return columns, -(-len(names) // columns) + sum(name.count("\n") for name in names)


def draw(results, layout):
    _, times = times_of(results)
    if not times:
        return None
    panels = panels_of(results, list(times))
    layout = layout.divided(len(panels))
    legends = [legend_rows(labels, layout.panel_width - 0.4) for labels in panels.values()]
    height = 3.4 + 0.17 * max(rows for _, rows in legends)
    figure, all_axes = grid(len(panels), layout, height, sharey=True)
    for axes, (title, labels), (of_legend, _) in zip(all_axes, panels.items(), legends):
        draw_panel(axes, {label: times[label] for label in labels}, Styles(labels), layout.panel_width - 1.1)
        axes.set_title(title)
        axes.legend(
            fontsize=LEGEND_SIZE,
            loc="upper left",
            bbox_to_anchor=(-0.02, -0.15),
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
    curved = [label for label, of_label in times.items() if grows_exponentially(of_label)]
    sentences = [
        f"Median wall time of the algorithm alone, on {family} unless its name says otherwise; lines are fitted through the"
        " logarithms of the upper half of the sizes, and the legend states their slope: the time grows like n to that power."
        f" Times below {1e6 * SMALLEST_FITTED_TIME_S:.0f} µs are drawn but not fitted, and sizes that span less than a factor"
        f" of {SMALLEST_SPAN} say nothing about growth."
    ]
    if results.judges_claims:
        sentences.append("The report’s literal algorithms have a panel of their own.")
    if curved:
        sentences.append(f"No power of n fits {', '.join(curved)}: an exponential function does.")
    return " ".join(sentences)
