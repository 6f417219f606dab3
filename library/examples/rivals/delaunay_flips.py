#!/usr/bin/python3
"""A rival in Python: SciPy's Delaunay triangulation, then flips to the shorter diagonal until none is left.

    delaunay_flips.py POINTS TRIANGLES     points as "x y" lines, triangles as "a,b,c" lines

harness/run/COMMANDS.md is the contract. Not exact: nearly collinear points may make a triangulation that mwt's checker rejects.
"""
import json
import sys
import time

import numpy
from scipy.spatial import Delaunay


def turn(points, a, b, c):
    (ax, ay), (bx, by), (cx, cy) = points[a], points[b], points[c]
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


def distance(points, a, b):
    return float(numpy.hypot(*(points[a] - points[b])))


class Mesh:
    """Triangles by their directed sides: opposite[a, b] is the third corner of the triangle to the left of a -> b."""

    def __init__(self, points, triangles):
        self.points = points
        self.opposite = {}
        for a, b, c in triangles:
            self.add(*((a, b, c) if turn(points, a, b, c) > 0 else (a, c, b)))

    def add(self, a, b, c):
        self.opposite[a, b], self.opposite[b, c], self.opposite[c, a] = c, a, b

    def flip_if_shorter(self, a, b):
        """The four sides around the edge a - b if it was replaced by the other diagonal, else nothing."""
        c, d = self.opposite.get((a, b)), self.opposite.get((b, a))
        if c is None or d is None:
            return []
        is_convex = turn(self.points, d, b, c) > 0 and turn(self.points, c, a, d) > 0
        if not is_convex or distance(self.points, c, d) >= distance(self.points, a, b) * (1 - 1e-12):
            return []
        del self.opposite[a, b], self.opposite[b, a]
        self.add(d, b, c)
        self.add(c, a, d)
        return [(d, b), (b, c), (c, a), (a, d)]

    def triangles(self):
        return [(a, b, c) for (a, b), c in self.opposite.items() if a < b and a < c]


def main():
    points = numpy.loadtxt(sys.argv[1], ndmin=2)
    begin = time.perf_counter()
    mesh = Mesh(points, Delaunay(points).simplices.tolist())
    waiting = [side for side in mesh.opposite if side[0] < side[1]]
    flips = 0
    while waiting:
        around = mesh.flip_if_shorter(*waiting.pop())
        flips += bool(around)
        waiting += around
    took = time.perf_counter() - begin
    with open(sys.argv[2], "w", encoding="utf-8") as out:
        out.writelines(f"{a},{b},{c}\n" for a, b, c in mesh.triangles())
    print(json.dumps({"time_s": took, "counters": {"flips": flips}}))


if __name__ == "__main__":
    main()
