"""The figures, one module each: draw(results, layout) returns a matplotlib figure, or None if the results have nothing for
it; TITLE and CAPTION, or title(results) and caption(results) where they depend on the results; IS_FOLDED if the page shows only
the title at first. A figure chooses families and algorithms from the results, never from a list. To add one: its module and its line here."""
from . import (
    alpha_by_n,
    alpha_by_n_further,
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
    "alpha_by_n_further": alpha_by_n_further,
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


def title(module, results):
    return module.title(results) if hasattr(module, "title") else module.TITLE


def caption(module, results):
    return module.caption(results) if hasattr(module, "caption") else module.CAPTION
