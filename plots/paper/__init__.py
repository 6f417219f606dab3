"""The figures of a paper, drawn from the CSV files that `mwt report --paper` wrote: whatever is counted, fitted or tested is
computed there. FIGURES: a function each, which returns a matplotlib figure, or None if its data are missing."""
from .comparisons import pairs, ranks
from .curves import distributions, profiles
from .data import Data
from .growth import growth
from .trade_off import trade_off

__all__ = ["Data", "FIGURES"]

FIGURES = {
    "profiles": profiles,
    "distributions": distributions,
    "trade_off": trade_off,
    "growth": growth,
    "pairs": pairs,
    "ranks": ranks,
}
