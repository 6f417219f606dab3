"""The figures, one module each: a TITLE, a CAPTION and draw(results), which returns a matplotlib figure, or None if the
results have nothing for it. To add one: its module and its line here."""
from . import (
    alpha_by_n,
    alpha_distribution,
    flips,
    growth,
    hull_bound,
    quadtree_grid,
    same_points,
    time_by_n,
    trade_off,
)
from . import worked_examples

CHARTS = {
    "alpha_distribution": alpha_distribution,
    "alpha_by_n": alpha_by_n,
    "trade_off": trade_off,
    "time_by_n": time_by_n,
    "growth": growth,
}
GALLERY = {
    "worked_examples": worked_examples,
    "flips": flips,
    "hull_bound": hull_bound,
    "same_points": same_points,
    "quadtree_grid": quadtree_grid,
}
ALL = CHARTS | GALLERY
