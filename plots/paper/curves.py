"""Performance profiles and empirical distributions: steps that the program counted."""
from .data import legend_below, panel_height, panels

FLOOR = {"profile": 1e-9, "distribution": 1e-9}  # smaller excesses are drawn at the left edge


def steps(table, floor):
    """The curve of one algorithm from the left edge on: at `floor` already the share that is not above it."""
    known = table.dropna()
    below = known[known.iloc[:, 1] <= floor]["share"]
    rest = known[known.iloc[:, 1] > floor]
    return [floor, *rest.iloc[:, 1]], [below.max() if len(below) else 0.0, *rest["share"]]


def draw_steps(axes, table, looks, floor, right):
    for label, of_label in table.groupby("label", sort=False):
        x, y = steps(of_label, floor)
        axes.step([*x, right], [*y, y[-1]], where="post", markevery=(0.0, 0.19), **looks[label])
    axes.set_xscale("log")
    axes.set_xlim(floor, right)
    axes.set_ylim(-0.02, 1.03)


def edges(values, smallest):
    """Decades that hold the values; what is below the smallest is drawn at the left edge."""
    positive = values[values > smallest]
    if not len(positive):
        return smallest, 10 * smallest
    return max(positive.min() / 1.5, smallest), positive.max() * 1.5


def draw(data, name, columns, texts):
    measures = data.measures(name)
    if not measures:
        return None
    looks = data.looks()
    figure, all_axes = panels(len(measures), panel_height(looks))
    shown = []
    for axes, measure in zip(all_axes, measures):
        table = data.table(f"{name}_{measure}")
        scale, text = texts[measure]
        column = columns
        table[column] = table[column] * scale
        low, high = edges(table[column].dropna(), 1e-6 if measure == "gap" else 0)
        if name == "profile" and measure == "time":
            low = 1
        draw_steps(axes, table, looks, low, high)
        axes.set_xlabel(text)
        shown += [label for label in dict.fromkeys(table["label"]) if label not in shown]
    all_axes[0].set_ylabel("share of instances")
    legend_below(figure, looks, shown)
    return figure


def profiles(data):
    texts = {"gap": (100, "weight above the lightest, in percent"), "time": (1, "time over the shortest")}
    return draw(data, "profile", "ratio", texts)


def distributions(data):
    texts = {"gap": (100, "gap to the optimum, in percent"), "time": (1e6, "time per point, in microseconds")}
    return draw(data, "distribution", "value", texts)
