"""Where the proof of the source report's claim on hull insertion fails first."""
from figures.drawing import Gallery, dots, finish, triangulation
from figures.panels import grid

TITLE = "A hull that weighs more than the whole"
CAPTION = (
    "Section 5.2.4 of the source report states that the hull's optimal triangulation never outweighs the optimum of all points. Twelve points"
    " in convex position, optimally triangulated, and the same with one more point inside: the optimum becomes lighter."
)


def draw(results, layout):
    gallery = Gallery(results)
    if not gallery.has("hull_only.csv", "hull_bound_counterexample.csv"):
        return None
    layout = layout.divided(2)
    figure, all_axes = grid(2, layout, 0.85 * layout.panel_width)
    for axes, name, text in zip(
        all_axes, ("hull_only", "hull_bound_counterexample"), ("the hull alone", "with the inner point")
    ):
        points = gallery.points(name)
        triangulation(axes, points, gallery.edges(name, "exact"))
        dots(axes, points, 10)
        finish(axes, gallery.points("hull_only"), f"{text}: {gallery.solution(name, 'exact')['weight_upper']:.3f}")
    figure.tight_layout()
    return figure
