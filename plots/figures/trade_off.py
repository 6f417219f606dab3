"""Quality against time: excess over the optimum against running time, at the largest n that the study has in common."""
import math

from figures.panels import coincident, grid, large_enough, legend, name_panel, percent_ticks, set_time_ticks
from library.style import INK, Styles

TITLE = "Quality against time"
LOWEST_DECADE = -6
ENOUGH_ALGORITHMS = 5
MOST_PANELS = 6
NEARLY_ALL = 0.85  # of the algorithms


def sizes_of(counts):
    """Of the numbers of algorithms by n: the largest n with many, and the largest at which nearly all can be compared."""
    many = counts.index[counts >= min(ENOUGH_ALGORITHMS, counts.max())].max()
    most = counts.index[counts >= NEARLY_ALL * counts.max()].max()
    return sorted({int(many), int(most)}, reverse=True)


def chosen(results):
    """The panels: {n: [(family, cells of several algorithms), ...]}."""
    cells = large_enough(results.rated_cells[results.rated_cells["wall_time_median_s"].notna()])
    counts = cells.groupby(["n", "family"])["label"].nunique()
    counts = counts[counts > 1]
    if counts.empty:
        return {}
    panels = {}
    sizes = sizes_of(counts.groupby("n").max())
    for n in sizes:
        families = [family for family in results.families if (n, family) in counts.index][: MOST_PANELS // len(sizes)]
        of_n = cells[cells["n"] == n]
        panels[n] = [(family, of_n[of_n["family"] == family]) for family in families]
    return panels


def front(points):
    """Those that no other beats in both, by time."""
    best = float("inf")
    kept = []
    for label, time, excess in sorted(points, key=lambda point: (point[1], point[2])):
        if excess < best:
            best = excess
            kept.append((label, time, excess))
    return kept


def draw_panel(axes, cells, labels, styles):
    medians = cells.set_index("label")[["wall_time_median_s", "alpha_median"]]
    points = [
        (label, medians["wall_time_median_s"][label], max(medians["alpha_median"][label] - 1, 10.0**LOWEST_DECADE))
        for label in labels
        if label in medians.index
    ]
    steps = front(points)
    axes.step(
        [time for _, time, _ in steps], [excess for _, _, excess in steps], where="post", color=INK, linewidth=0.8
    )
    equal = coincident({label: place for label, *place in points})
    for label, time, excess in points:
        if label in equal:
            name = " = ".join([label, *equal[label]])
            axes.plot(time, excess, label=name, clip_on=False, markersize=7, **styles.mark(label))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.minorticks_off()


def rows_of(panels, columns):
    """(n, family, cells) row by row, every n in rows of its own; None fills them up."""
    cells = []
    for n, of_n in panels.items():
        cells += [(n, *panel) for panel in of_n] + [None] * (-len(of_n) % columns)
    return cells


def draw(results, layout):
    panels = chosen(results)
    if not panels:
        return None
    present = {label for of_n in panels.values() for _, of_family in of_n for label in of_family["label"]}
    labels = [label for label in results.labels if label in present]
    styles = Styles(labels)
    cells = rows_of(panels, min(layout.columns, max(map(len, panels.values()))))
    figure, all_axes = grid(len(cells), layout, 3.3, sharey=True)
    for axes, cell in zip(all_axes, cells):
        axes.set_visible(cell is not None)
        if cell is not None:
            n, family, of_family = cell
            draw_panel(axes, of_family, labels, styles)
            name_panel(axes, f"{family}, n = {n:,}", layout)
            axes.set_xlabel("wall time")
            set_time_ticks(axes.xaxis, most=4)
    worst = max(of_family["alpha_median"].max() for of_n in panels.values() for _, of_family in of_n)
    ticks, texts = percent_ticks(LOWEST_DECADE, max(-2, math.ceil(math.log10(max(worst - 1, 1e-9)))))
    all_axes[0].set_ylim(ticks[0] / 1.6, ticks[-1] * 1.2)
    all_axes[0].set_yticks(ticks, texts)
    for axes in all_axes[:: layout.columns]:
        axes.set_ylabel(r"excess $\alpha - 1$")
    legend(figure, all_axes, layout)
    return figure


def caption(results):
    sizes = list(chosen(results))
    return (
        "Median excess over the proved optimum against median running time, one panel per family, at"
        f" {' and at '.join(f'n = {n:,}' for n in sizes)}: the largest size that many algorithms reach"
        f"{', and the largest at which nearly all can be compared' if len(sizes) > 1 else ''}. The stepped line is the Pareto"
        " front: nothing is both faster and better. Optimal results lie on the bottom line."
    )
