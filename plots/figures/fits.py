"""Straight lines through logarithms, for drawing; the verdicts' own fits, with intervals, are the harness's."""
import numpy as np

LEAST_MISFIT = 0.1  # of log y, below which a power law is good enough whatever else fits


def power_law(n, y):
    """(exponent, factor) of the least-squares line through (log n, log y)."""
    exponent, height = np.polyfit(np.log(n), np.log(y), 1)
    return exponent, np.exp(height)


def upper_half(by_n):
    """What a law of growth is fitted to: the larger half of more than five sizes, which small costs disturb least."""
    return by_n[len(by_n) // 2 :] if len(by_n) > 5 else by_n


def is_exponential(n, y):
    """Whether log y is much straighter against n than against log n. Needs four sizes."""
    if len(n) < 4:
        return False
    log_y = np.log(y)
    misfits = [np.sqrt(np.mean((log_y - np.polyval(np.polyfit(x, log_y, 1), x)) ** 2)) for x in (np.log(n), n)]
    return bool(misfits[0] > LEAST_MISFIT and misfits[1] < misfits[0] / 2)
