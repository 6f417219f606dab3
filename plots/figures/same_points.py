"""The same points triangulated by every algorithm."""
from figures.drawing import Gallery, dots, excess, finish, triangulation
from figures.panels import fold, grid
from library.style import Layout, report_first

TITLE = "The same 60 points, every algorithm"
CAPTION = (
    "Uniform points. Broad pale lines: the proved optimum; vermilion: edges that the optimum does not have; the figure"
    " is the excess over the optimum’s length."
)
SET = "same_points"
OPTIMUM = "optimum"  # the name that plots/gallery.sh gives the triangulation to compare with


def draw(results, layout):
    gallery = Gallery(results)
    labels = report_first(gallery.names(SET, but=[OPTIMUM]))
    if not labels:
        return None
    points = gallery.points(SET)
    optimum = gallery.edges(SET, OPTIMUM)
    if layout.is_narrow:
        layout = Layout(2, layout.panel_width / 2, layout.margin)
    figure, panels = grid(len(labels), layout, 1.05 * layout.panel_width)
    for axes, label in zip(panels, labels):
        triangulation(axes, points, gallery.edges(SET, label), optimum, linewidth=0.7)
        dots(axes, points, 5)
        finish(axes, points, fold(f"{label}: {excess(gallery.solution(SET, label))}", layout.panel_width))
    figure.tight_layout()
    return figure
