"""Triangulations drawn: points, edges, the optimum underneath, and what differs from it."""
import csv
import json

from matplotlib.patches import PathPatch
from matplotlib.path import Path

from library.style import INK, OPTIMUM, PAPER, VERMILION


class Gallery:
    """The files that plots/gallery.sh made in a results folder."""

    def __init__(self, results):
        self.folder = results.folder / "gallery"

    def has(self, *names):
        return all((self.folder / name).is_file() for name in names)

    def names(self, name, but=()):
        """The names of the triangulations of a set of points."""
        found = [path.name[len(name) + 1 : -len(".json")] for path in self.folder.glob(f"{name}.*.json")]
        return sorted(set(found) - set(but))

    def _rows(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def points(self, name):
        return [(float(row["x"]), float(row["y"])) for row in self._rows(f"{name}.csv")]

    def edges(self, name, algorithm):
        triangles = [(int(row["a"]), int(row["b"]), int(row["c"])) for row in self._rows(f"{name}.{algorithm}.csv")]
        return {tuple(sorted(pair)) for a, b, c in triangles for pair in ((a, b), (b, c), (c, a))}

    def solution(self, name, algorithm):
        return json.loads((self.folder / f"{name}.{algorithm}.json").read_text())


def lines(axes, points, edges, **style):
    """The edges as one path, which keeps files small."""
    ends = [points[end] for edge in sorted(edges) for end in edge]
    if ends:
        path = Path(ends, [Path.MOVETO, Path.LINETO] * len(edges))
        axes.add_patch(PathPatch(path, fill=False, capstyle="round", **style))


def triangulation(axes, points, edges, optimum=frozenset(), differing=True, linewidth=0.9):
    """The optimum's edges broad and pale underneath; edges that it lacks in vermilion, unless `differing` is false."""
    lines(axes, points, optimum, edgecolor=OPTIMUM, linewidth=4 * linewidth)
    other = edges - optimum if optimum and differing else set()
    lines(axes, points, edges - other, edgecolor=INK, linewidth=linewidth)
    lines(axes, points, other, edgecolor=VERMILION, linewidth=1.5 * linewidth)


def dots(axes, points, size=7, names=None, font=7.5):
    axes.scatter(*zip(*points), s=size, color=INK, zorder=3, linewidth=0)
    for (x, y), name in zip(points, names or []):
        axes.annotate(
            name,
            (x, y),
            xytext=(3, 3),
            textcoords="offset points",
            fontsize=font,
            zorder=4,
            bbox={"boxstyle": "round,pad=0.1", "facecolor": PAPER, "edgecolor": "none", "alpha": 0.8},
        )


def finish(axes, points, title):
    """The same scale for x and y, some air around, nothing else."""
    xs, ys = zip(*points)
    air = 0.06 * max(max(xs) - min(xs), max(ys) - min(ys))
    axes.set_xlim(min(xs) - air, max(xs) + air)
    axes.set_ylim(min(ys) - air, max(ys) + air)
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title, fontsize=8.5, loc="center")


def excess(solution):
    """ "+1.3 %", "optimal", or nothing where the optimum is not proved."""
    if solution["optimality"] != "proved":
        return ""
    if solution["alpha_upper"] - 1 < 1e-9:
        return "optimal"
    return f"+{100 * (solution['alpha_upper'] - 1):.3g}\u00a0%"
