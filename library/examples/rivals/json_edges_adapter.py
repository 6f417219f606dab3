#!/usr/bin/python3
"""Lets a solver that reads points and writes edges as JSON take part as a command of mwt.

    json_edges_adapter.py POINTS EDGES SOLVER [ARGUMENT...]

The solver gets {"points": [{"x": 0, "y": 0}, ...]} in a file, and must write {"edges": [{"i": 0, "j": 1}, ...]} or
{"edges": [[0, 1], ...]}, all edges of its triangulation, hull included, to another one; {in} and {out} among its arguments stand for
them, and without these they are its last two arguments. This is the form of the CG:SHOP challenges, and near to that of the minimum
weight triangulation solver of Fekete, Haas, Keldenich, Perk and Schmidt; change `edges_of` if yours differs. If the file has an
"objective_lower_bound", it becomes a claimed lower bound.
"""
import json
import pathlib
import subprocess
import sys
import tempfile


def edges_of(answer):
    for edge in answer["edges"]:
        yield (edge["i"], edge["j"]) if isinstance(edge, dict) else (edge[0], edge[1])


def main():
    points_file, edges_file, *solver = sys.argv[1:]
    lines = pathlib.Path(points_file).read_text(encoding="utf-8").splitlines()
    points = [dict(zip("xy", map(float, line.split()))) for line in lines]
    with tempfile.TemporaryDirectory() as folder:
        given, answered = pathlib.Path(folder) / "points.json", pathlib.Path(folder) / "edges.json"
        given.write_text(json.dumps({"points": points}), encoding="utf-8")
        if not any(word in ("{in}", "{out}") for word in solver):
            solver += ["{in}", "{out}"]
        names = {"{in}": str(given), "{out}": str(answered)}
        done = subprocess.run([names.get(word, word) for word in solver], check=False)
        if done.returncode:
            sys.exit(done.returncode if done.returncode > 0 else 128 - done.returncode)
        answer = json.loads(answered.read_text(encoding="utf-8"))
    with open(edges_file, "w", encoding="utf-8") as out:
        out.writelines(f"{i},{j}\n" for i, j in edges_of(answer))
    if "objective_lower_bound" in answer:
        print(json.dumps({"lower_bound": answer["objective_lower_bound"]}))


if __name__ == "__main__":
    main()
