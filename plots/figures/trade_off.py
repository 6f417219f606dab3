"""What time buys: excess over the optimum against running time, at the largest n that the study has in common."""
import matplotlib.pyplot as plt

from library.records import RANDOM_FAMILIES
from library.style import INK, Styles, report_first

TITLE = "What time buys"
CAPTION = (
    "Median excess over the proved optimum against median running time at n = {n:,}, one panel per family. The stepped line is "
    "the Pareto front: nothing is both faster and better. Optimal results lie on the bottom line."
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
    points = [(label, cell["wall_time_s"].median(), max((cell["alpha_upper"] - 1).median(), LOWEST_EXCESS))
              for label, cell in cells.groupby("label")]
    steps = front(points)
    axes.step([time for _, time, _ in steps], [excess for _, _, excess in steps], where="post", color=INK, linewidth=0.8)
    for label, time, excess in points:
        style = dict(styles[label], linestyle="")
        axes.plot(time, excess, clip_on=False, markersize=7, **style)
    axes.set_xscale("log")
    axes.set_yscale("log")
    times = [time for _, time, _ in points]
    axes.set_xlim(min(times) / 2, max(times) * (max(times) / min(times)) ** 0.45)  # room for names
    return points


def place_names(axes, points):
    """Names beside the marks, moved up where they would meet. The axes must have their final size."""
    to_pixels = axes.transData.transform
    taken = []
    for label, time, excess in sorted(points, key=lambda point: point[2]):
        x, y = to_pixels((time, excess))
        shift = 0
        while any(abs(x - other_x) < 75 and abs(y + shift - other_y) < 12 for other_x, other_y in taken):
            shift += 3
        taken.append((x, y + shift))
        axes.annotate(label, (time, excess), xytext=(6, 2 + shift * 72 / axes.figure.dpi), textcoords="offset points", fontsize=7.5)


def draw(results):
    n = largest_common_n(results.rated)
    if n is None:
        return None
    cells = results.rated[results.rated["n"] == n]
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
