"""The report's ten points A .. J, triangulated by its two algorithms."""
import matplotlib.pyplot as plt

from figures.drawing import Gallery, dots, excess, finish, triangulation

TITLE = "The report's worked example"
CAPTION = (
    "The ten points of sections 5.1.3 and 5.2.3. Broad pale lines: the optimum; vermilion: edges that it does not have."
    " Greedy finds the optimum; hull insertion, with the report's twelve triangles, is 22 % longer. The points are not"
    " in general position, as the report requires: B, H, J; E, H, I and F, G, H lie on lines."
)
SET = "report_example"
SHOWN = {"greedy_report": "greedy (5.1)", "hull_insertion": "hull DP + insertion (5.2)"}


def draw(results):
    gallery = Gallery(results)
    if not gallery.has(f"{SET}.csv"):
        return None
    points = gallery.points(SET)
    optimum = gallery.edges(SET, "exact")
    figure, all_axes = plt.subplots(1, 2, figsize=(8, 3.7))
    for axes, (algorithm, name) in zip(all_axes, SHOWN.items()):
        triangulation(axes, points, gallery.edges(SET, algorithm), optimum, linewidth=1.1)
        dots(axes, points, 12, "ABCDEFGHIJ")
        solution = gallery.solution(SET, algorithm)
        finish(axes, points, f"{name}: {solution['weight_upper']:.4f}, {excess(solution)}")
    figure.tight_layout()
    return figure
