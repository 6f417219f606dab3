"""The quadtree's grid and the triangulation that is merged from it."""
from matplotlib.patches import Rectangle

from figures.drawing import Gallery, dots, excess, finish, triangulation
from figures.panels import grid
from library.style import ORANGE

TITLE = "The quadtree's grid"
CAPTION = (
    "Section 5.4 of the source report on 150 clustered points: the bounding square is split until no cell holds more than four"
    " points (first picture); each cell is triangulated by itself and merged with its neighbours (second; vermilion: edges that"
    " the optimum, pale, does not have)."
)
SET = "grid_points"
CAPACITY = 4


def leaves(points, x, y, size):
    """(x, y, size) of the cells that are not split further: half-open squares, as geometry/quadtree.h describes them."""
    if len(points) <= CAPACITY:
        return [(x, y, size)]
    half = size / 2
    return [
        leaf
        for left in (x, x + half)
        for bottom in (y, y + half)
        for leaf in leaves(
            [(px, py) for px, py in points if (px >= x + half) == (left > x) and (py >= y + half) == (bottom > y)],
            left,
            bottom,
            half,
        )
    ]


def draw(results, layout):
    gallery = Gallery(results)
    if not gallery.has(f"{SET}.csv"):
        return None
    points = gallery.points(SET)
    xs, ys = zip(*points)
    cells = leaves(points, min(xs), min(ys), max(max(xs) - min(xs), max(ys) - min(ys)))
    layout = layout.divided(2)
    figure, all_axes = grid(2, layout, 1.06 * layout.panel_width)
    for x, y, size in cells:
        all_axes[0].add_patch(Rectangle((x, y), size, size, facecolor="none", edgecolor=ORANGE, linewidth=0.8))
    dots(all_axes[0], points, 6)
    finish(
        all_axes[0],
        [(min(xs), min(ys)), (min(xs) + cells_side(cells), min(ys) + cells_side(cells))],
        f"{len(cells)} cells",
    )
    triangulation(all_axes[1], points, gallery.edges(SET, "quadtree"), gallery.edges(SET, "exact"), linewidth=0.6)
    dots(all_axes[1], points, 5)
    finish(all_axes[1], points, f"quadtree: {excess(gallery.solution(SET, 'quadtree'))}")
    figure.tight_layout()
    return figure


def cells_side(cells):
    """The side of the square that the cells partition."""
    return sum(size * size for _, _, size in cells) ** 0.5
