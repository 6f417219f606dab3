"""What time buys: excess over the optimum against running time, at the largest n that the study has in common."""
import matplotlib.pyplot as plt

from library.records import RANDOM_FAMILIES
from library.style import INK, Styles, report_first

TITLE = "What time buys"
CAPTION = (
    "Median excess over the proved optimum against median running time at n = {n:,}, one panel per family. The stepped"
    " line is the Pareto front: nothing is both faster and better. Optimal results lie on the bottom line."
)
LOWEST_EXCESS = 1e-6
FEWEST_ALGORITHMS = 5


def largest_common_n(rated):
    counts = rated[rated["family"].isin(RANDOM_FAMILIES)].groupby("n")["label"].nunique()
    counts = counts[counts >= FEWEST_ALGORITHMS]
    return int(counts.index.max()) if len(counts) else None


def front(points):
    """Those that no other beats in both, by time."""
    best = float("inf")
    kept = []
    for label, time, excess in sorted(points, key=lambda point: (point[1], point[2])):
        if excess < best:
            best = excess
            kept.append((label, time, excess))
    return kept


def draw_panel(axes, cells, styles):
    points = [
        (label, cell["wall_time_s"].median(), max((cell["alpha_upper"] - 1).median(), LOWEST_EXCESS))
        for label, cell in cells.groupby("label")
    ]
    steps = front(points)
    axes.step(
        [time for _, time, _ in steps], [excess for _, _, excess in steps], where="post", color=INK, linewidth=0.8
    )
    for label, time, excess in points:
        style = dict(styles[label], linestyle="")
        axes.plot(time, excess, clip_on=False, markersize=7, **style)
    axes.set_xscale("log")
    axes.set_yscale("log")
    times = [time for _, time, _ in points]
    axes.set_xlim(min(times) / 2, max(times) * (max(times) / min(times)) ** 0.45)  # room for names
    return points


def place_names(axes, points):
    """Names beside the marks, where they meet neither marks nor other names. The axes must have their final size."""
    places = [
        ("left", (6, 2)),
        ("left", (6, -9)),
        ("right", (-6, 2)),
        ("left", (2, 7)),
        ("left", (2, -14)),
        ("left", (6, 13)),
    ]
    marks = [axes.transData.transform((time, excess)) for _, time, excess in points]
    taken = [(x - 6, y - 6, x + 6, y + 6) for x, y in marks]
    pixel = axes.figure.dpi / 72
    for (label, time, excess), (x, y) in sorted(zip(points, marks), key=lambda item: item[0][2]):
        width, height = 4.6 * pixel * len(label), 9 * pixel
        for alignment, (dx, dy) in places:
            left = x + dx * pixel - (width if alignment == "right" else 0)
            bottom = y + (dy - 1) * pixel
            box = (left, bottom, left + width, bottom + height)
            if not any(overlap(box, other) for other in taken):
                break
        taken.append(box)
        axes.annotate(label, (time, excess), xytext=(dx, dy), textcoords="offset points", fontsize=7.5, ha=alignment)


def overlap(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def draw(results):
    n = largest_common_n(results.rated)
    if n is None:
        return None
    cells = results.rated[(results.rated["n"] == n) & ~results.rated["label"].str.contains(" ")]  # usual configurations
    families = [family for family in RANDOM_FAMILIES if family in set(cells["family"])]
    styles = Styles(report_first(set(cells["label"])))
    figure, grid = plt.subplots(1, len(families), figsize=(3.3 * len(families) + 0.4, 3.6), sharey=True, squeeze=False)
    drawn = []
    for axes, family in zip(grid[0], families):
        drawn.append((axes, draw_panel(axes, cells[cells["family"] == family], styles)))
        axes.set_title(f"{family}, n = {n:,}")
        axes.set_xlabel("wall time in s")
        axes.minorticks_off()
    ticks = [10.0**d for d in range(-6, 2)]
    grid[0][0].set_yticks(ticks, ["optimal"] + [f"{100 * tick:,g} %" for tick in ticks[1:]])
    grid[0][0].set_ylim(LOWEST_EXCESS / 1.6, None)
    grid[0][0].set_ylabel(r"excess $\alpha - 1$")
    figure.tight_layout()
    for axes, points in drawn:
        place_names(axes, points)
    return figure


def caption(results):
    return CAPTION.format(n=largest_common_n(results.rated) or 0)
