"""Straight lines through logarithms, for drawing; the verdicts' own fits, with intervals, are the harness's."""
import numpy as np


def power_law(n, y):
    """(exponent, factor) of the least-squares line through (log n, log y)."""
    exponent, height = np.polyfit(np.log(n), np.log(y), 1)
    return exponent, np.exp(height)
