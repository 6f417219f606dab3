"""Minimum weight triangulation: heuristics, proved optima, instances.

    import mwt
    points = mwt.generate("uniform", 1000, seed=1)            # array of shape (n, 2)
    greedy = mwt.triangulate(points, algorithm="greedy")
    optimum = mwt.solve(points, threads=2)
    greedy.alpha(optimum)                                     # certified interval

Weights and bounds are certified intervals (lower, upper). Mistakes in what is given raise ValueError with the words of the program mwt.
"""
from ._mwt import version as _version
from ._api import (  # noqa: F401
    Entry,
    Interval,
    Parameter,
    Proof,
    Triangulation,
    algorithms,
    check,
    families,
    generate,
    read_points,
    solve,
    triangulate,
    verify,
    weight,
)

__version__ = _version()
__all__ = [
    "Entry", "Interval", "Parameter", "Proof", "Triangulation", "algorithms", "check", "families", "generate", "read_points", "solve",
    "triangulate", "verify", "weight",
]
