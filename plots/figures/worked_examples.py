"""The source report's ten points A .. J, triangulated by its two algorithms."""
from figures.drawing import Gallery, dots, excess, finish, triangulation
from figures.panels import fold, grid

TITLE = "The source report's worked example"
CAPTION = (
    "The ten points of sections 5.1.3 and 5.2.3. Broad pale lines: the optimum; vermilion: edges that it does not have."
    " Greedy finds the optimum; hull insertion, with the source report's twelve triangles, is 22 % longer. The points are not"
    " in general position, which the source report requires: B, H, J; E, H, I and F, G, H lie on lines."
)
SET = "report_example"
SHOWN = {"greedy_naive": "greedy (5.1)", "hull_insertion": "hull DP + insertion (5.2)"}


def draw(results, layout):
    gallery = Gallery(results)
    if not gallery.has(f"{SET}.csv"):
        return None
    points = gallery.points(SET)
    optimum = gallery.edges(SET, "exact")
    layout = layout.divided(len(SHOWN))
    figure, all_axes = grid(len(SHOWN), layout, 0.85 * layout.panel_width)
    for axes, (algorithm, name) in zip(all_axes, SHOWN.items()):
        triangulation(axes, points, gallery.edges(SET, algorithm), optimum, linewidth=1.1)
        dots(axes, points, 12, "ABCDEFGHIJ")
        solution = gallery.solution(SET, algorithm)
        text = f"{name}: {solution['weight_upper']:.4f}, {excess(solution)}"
        finish(axes, points, fold(text, layout.panel_width))
    figure.tight_layout()
    return figure
