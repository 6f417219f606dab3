"""The source report's local search, flip by flip."""
from figures.drawing import Gallery, dots, finish, lines, triangulation
from figures.panels import fold, grid
from library.style import GREEN, VERMILION

TITLE = "The source report's local search, flip by flip"
CAPTION = (
    "Figures 9 to 11 of the source report, redrawn from points recovered from its printed perimeters. Dashed vermilion: the"
    " edge about to be flipped; green: the edge that took its place. Each state has exactly one flip that improves, the"
    " last has none."
)
SET = "local_search_figure"
STATES = ("flips0", "flips1", "flips2")
NAMES = ("start", "after the first flip", "after the second")


def draw(results, layout):
    gallery = Gallery(results)
    if not gallery.has(f"{SET}.csv"):
        return None
    points = gallery.points(SET)
    states = [gallery.edges(SET, state) for state in STATES]
    figure, all_axes = grid(len(STATES), layout, 3.4)
    for step, (axes, edges) in enumerate(zip(all_axes, states)):
        leaving = edges - states[step + 1] if step + 1 < len(states) else set()
        entered = edges - states[step - 1] if step > 0 else set()
        triangulation(axes, points, edges - leaving - entered)
        lines(axes, points, leaving, edgecolor=VERMILION, linewidth=1.6, linestyle="--")
        lines(axes, points, entered, edgecolor=GREEN, linewidth=2)
        dots(axes, points, 10, [str(index) for index in range(len(points))])
        total = gallery.solution(SET, STATES[step])["perimeter_sum"]
        finish(axes, points, fold(f"{NAMES[step]}: perimeters {total:.4f}", layout.panel_width))
    figure.tight_layout()
    return figure
