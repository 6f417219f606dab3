"""What the charts share: grids of panels, the axis of the excess over the optimum, marks that do not hide each other."""
import math
import textwrap

import matplotlib.pyplot as plt
import numpy as np

from library.records import OPTIMAL
from library.style import legend_below, report_first

SMALLEST_N = 20  # below, nearly every algorithm is optimal
MARK_WIDTH = 4.5  # points
FONT_SIZE = 8.5  # points, unless a text has another
TIME_TICKS = {
    1e-7: "100 ns",
    1e-6: "1 µs",
    1e-5: "10 µs",
    1e-4: "100 µs",
    1e-3: "1 ms",
    1e-2: "10 ms",
    1e-1: "100 ms",
    1: "1 s",
    10: "10 s",
    100: "100 s",
    1000: "1000 s",
}


def grid(count, layout, height, **sharing):
    """A figure with `count` panels of that height in inches, and the panels, row by row."""
    columns = min(layout.columns, count)
    rows = -(-count // columns)
    figure, axes = plt.subplots(
        rows, columns, figsize=(layout.width(columns), height * rows + 0.2), squeeze=False, **sharing
    )
    panels = list(axes.flat)
    for unused in panels[count:]:
        unused.set_visible(False)
    return figure, panels[:count]


def fold(text, inches, font_size=FONT_SIZE):
    """The text in lines that fit."""
    return "\n".join(textwrap.wrap(text, max(12, int(110 / font_size * inches)), break_long_words=False))


def name_panel(axes, text, layout):
    axes.set_title(fold(text, 0.85 * layout.panel_width - 0.5))  # bold, and beside the axis


def legend(figure, panels, layout):
    """One legend for what the panels show: each name once."""
    shown = {}
    for axes in panels:
        for handle, name in zip(*axes.get_legend_handles_labels()):
            shown.setdefault(name, handle)
    names = report_first(shown)
    inches = layout.width(layout.columns) - 0.5
    legend_below(figure, [shown[name] for name in names], [fold(name, inches) for name in names])


def large_enough(observations):
    """What is not trivially small, if that leaves anything to compare sizes with."""
    large = observations[observations["n"] >= SMALLEST_N]
    return large if large["n"].nunique() > 1 or observations["n"].nunique() < 2 else observations


def always_optimal(observations):
    """The labels whose every rated result is optimal."""
    worst = observations.groupby("label")["alpha_upper"].max()
    return set(worst[worst <= OPTIMAL].index)


def equal_labels(observations, labels):
    """{label: labels that have the same alphas on all of their instances, which are instances of `label` too}.

    Labels that stand in no other's list are its keys; of equal ones, that with most instances, and no variant if possible."""
    alphas = {
        label: of_label.set_index(["family", "instance_id"])["alpha_upper"]
        for label, of_label in observations.groupby("label")
    }
    groups = {}
    for label in sorted(labels, key=lambda label: (-len(alphas[label]), " " in label)):
        same = next((first for first in groups if are_equal(alphas[first], alphas[label])), None)
        if same is None:
            groups[label] = []
        else:
            groups[same].append(label)
    return {label: groups[label] for label in labels if label in groups}


def are_equal(larger, smaller):
    common = larger.reindex(smaller.index)
    return len(smaller) > 2 and bool(np.isclose(common, smaller, rtol=1e-9, atol=0).all())  # missing ones are not


def coincident(series):
    """{label: labels whose values are the same}, of {label: values}: of those that would hide each other, the first stands for all."""
    groups = {}
    for label, values in series.items():
        same = next((first for first in groups if np.array_equal(series[first], values)), None)
        if same is None:
            groups[label] = []
        else:
            groups[same].append(label)
    return groups


def side_by_side(axes, marks):
    """Positions for marks (x, y) on logarithmic axes of final scale: those that would hide each other stand in a row around
    their x, no nearer to those at the next x than half way. y stays."""
    if not marks:
        return []
    decade = axes.get_window_extent().width * 72 / axes.figure.dpi / math.log10(axes.get_xlim()[1] / axes.get_xlim()[0])
    height = axes.get_window_extent().height * 72 / axes.figure.dpi
    low, high = (math.log10(y) for y in axes.get_ylim())
    xs = sorted({x for x, _ in marks})
    gap = min((math.log10(b / a) for a, b in zip(xs, xs[1:])), default=1)
    placed = list(marks)
    for x in xs:
        column = sorted((y, i) for i, (at, y) in enumerate(marks) if at == x)
        for cluster in clusters(column, MARK_WIDTH * (high - low) / height):
            step = min(MARK_WIDTH / decade, 0.9 * gap / len(cluster))
            for place, (y, i) in enumerate(cluster):
                placed[i] = (x * 10 ** (step * (place - (len(cluster) - 1) / 2)), y)
    return placed


def clusters(column, nearness):
    """Groups of (y, i), sorted by y, whose neighbours are nearer than `nearness` decades."""
    groups = []
    for y, i in column:
        if groups and math.log10(y / groups[-1][-1][0]) < nearness:
            groups[-1].append((y, i))
        else:
            groups.append([(y, i)])
    return [sorted(group, key=lambda item: item[1]) for group in groups]


def percent_ticks(lowest, highest):
    """(ticks, texts) of an axis for alpha - 1 from 10^lowest, which stands for optimal, to 10^highest."""
    ticks = [10.0**decade for decade in range(lowest, highest + 1)]
    return ticks, ["optimal"] + [f"{100 * tick:,g} %" for tick in ticks[1:]]


def set_time_ticks(axis, most=len(TIME_TICKS)):
    """Of a logarithmic axis of seconds: powers of ten with units, evenly left out where they are more than `most`."""
    low, high = axis.get_view_interval()
    ticks = [tick for tick in TIME_TICKS if low <= tick <= high]
    ticks = ticks[:: max(1, -(-len(ticks) // most))]
    axis.set_ticks(ticks, [TIME_TICKS[tick] for tick in ticks])
