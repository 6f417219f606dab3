"""Two studies: by how much their times and alphas differ, one row per algorithm, every cell a mark. For plots/make_comparison.py."""
import matplotlib.pyplot as plt
import numpy as np

from figures.panels import fold
from library.style import INK, Styles, report_first

TITLE = "By how much B differs from A"
SAME = 1e-11  # of alpha, which certified intervals are wide


def rows_of(cells, column):
    """[(label, values)]: of the labels that have any."""
    known = cells[cells[column].notna()]
    return [(label, known[known["label"] == label][column]) for label in report_first(set(known["label"]))]


def draw_rows(axes, rows, styles, middle, layout):
    axes.axvline(middle, color=INK, linewidth=0.8)
    for position, (label, values) in enumerate(rows):
        heights = position + np.random.default_rng(position).uniform(-0.28, 0.28, len(values))
        axes.scatter(values, heights, s=11, color=styles.colour(label), alpha=0.6, linewidth=0)
    axes.set_yticks(range(len(rows)), [fold(label, 0.4 * layout.panel_width) for label, _ in rows], fontsize=7.5)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.grid(axis="y", visible=False)
    axes.tick_params(axis="y", length=0)


def ratio_ticks(axes, values):
    """Powers of 2, or of 1.1 where the ratios are nearly 1."""
    worst = max(values.max(), 1 / values.min(), 1.02)
    base = 2 if worst > 2 else 1.2 if worst > 1.2 else 1.05
    steps = int(np.ceil(np.log(worst) / np.log(base)))
    every = -(-steps // 3)
    ticks = [base ** (step * every) for step in range(-3, 4)]
    axes.set_xscale("log")
    axes.set_xlim(base ** (-steps - 0.3), base ** (steps + 0.3))
    axes.set_xticks([tick for tick in ticks if 1 / worst / base <= tick <= worst * base])
    axes.set_xticklabels([f"{tick:.3g}" for tick in axes.get_xticks()])
    axes.minorticks_off()


def change_ticks(axes, values):
    """Decades on both sides of 0, at most three on a side."""
    worst = np.abs(values).max()
    top = int(np.ceil(np.log10(worst)))
    least = max(top - 4, -6)
    axes.set_xscale("symlog", linthresh=10.0**least, linscale=0.5)
    decades = range(top, least - 1, -max(1, -(-(top - least + 1) // 2)))
    ticks = [10.0**decade for decade in decades]
    axes.set_xlim(-(10.0**top) * 1.3, 10.0**top * 1.3)
    axes.set_xticks([-tick for tick in ticks] + [0, *ticks[::-1]])
    axes.set_xticklabels([f"{tick:.6g}" for tick in axes.get_xticks()], fontsize=7.5)
    axes.minorticks_off()


def changes_of(cells):
    """[(label, changes of alpha)]; none if alpha is the same everywhere."""
    return rows_of(cells, "alpha_change") if (cells["alpha_change"].abs() > SAME).any() else []


def caption(cells):
    sentences = ["Every mark is a cell (family and n) that both studies have; marks of one algorithm stand in a row, spread to be seen."]
    if cells["time_ratio"].notna().any():
        sentences.append("Times: the median of B over that of A.")
    if changes_of(cells):
        sentences.append("α: the mean of B minus that of A; the axis is linear near 0 and logarithmic outside.")
    elif cells["alpha_change"].notna().any():
        sentences.append("The mean α is the same in every cell, and not drawn.")
    return " ".join([*sentences, "Left of the line, B is faster or better."])


def draw(cells, layout):
    """None if both studies have no cell with times or alphas in common."""
    times, alphas = rows_of(cells, "time_ratio"), changes_of(cells)
    shown = [rows for rows in (times, alphas) if rows]
    if not shown:
        return None
    columns = 1 if layout.is_narrow else len(shown)
    height = 0.9 + 0.32 * max(map(len, shown))
    figure, panels = plt.subplots(
        len(shown) // columns, columns, figsize=(layout.width(layout.columns), height * len(shown) // columns), squeeze=False
    )
    panels = iter(panels.flat)
    styles = Styles(report_first({label for rows in shown for label, _ in rows}))
    if times:
        axes = next(panels)
        draw_rows(axes, times, styles, 1, layout)
        ratio_ticks(axes, np.concatenate([values for _, values in times]))
        axes.set_xlabel("time of B / time of A")
    if alphas:
        axes = next(panels)
        draw_rows(axes, alphas, styles, 0, layout)
        axes.set_xlabel("change of mean α, B − A")
        change_ticks(axes, np.concatenate([values for _, values in alphas]))
    figure.tight_layout()
    return figure
