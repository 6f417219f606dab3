#!/usr/bin/python3
"""Speaks as the solvers do for which json_edges_adapter.py is made: json_stub.py POINTS.json EDGES.json. Its triangulation is Delaunay's,
and its lower bound half of that."""
import json
import math
import sys

from scipy.spatial import Delaunay

with open(sys.argv[1], encoding="utf-8") as given:
    points = [(point["x"], point["y"]) for point in json.load(given)["points"]]
edges = {tuple(sorted((int(t[i]), int(t[i - 1])))) for t in Delaunay(points).simplices for i in range(3)}
weight = sum(math.dist(points[i], points[j]) for i, j in edges)
with open(sys.argv[2], "w", encoding="utf-8") as out:
    json.dump({"edges": [{"i": i, "j": j} for i, j in sorted(edges)], "objective_lower_bound": weight / 2}, out)
