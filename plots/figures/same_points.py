"""The same points triangulated by every algorithm."""
import matplotlib.pyplot as plt

from figures.drawing import Gallery, dots, excess, finish, triangulation

TITLE = "The same 60 points, every algorithm"
CAPTION = (
    "Uniform points. Broad pale lines: the proved optimum; vermilion: edges that the optimum does not have; the figure"
    " is the excess over the optimum's length."
)
SET = "same_points"
ALGORITHMS = (
    "hull_insertion",
    "sweep",
    "quadtree",
    "delaunay",
    "flip_report",
    "annealing",
    "greedy_report",
    "patch",
    "exact",
)


def draw(results):
    gallery = Gallery(results)
    if not gallery.has(f"{SET}.csv"):
        return None
    points = gallery.points(SET)
    optimum = gallery.edges(SET, "exact")
    figure, grid = plt.subplots(3, 3, figsize=(9.2, 9.6))
    for axes, algorithm in zip(grid.flat, ALGORITHMS):
        triangulation(axes, points, gallery.edges(SET, algorithm), optimum, linewidth=0.7)
        dots(axes, points, 5)
        finish(axes, points, f"{algorithm}: {excess(gallery.solution(SET, algorithm))}")
    figure.tight_layout()
    return figure
