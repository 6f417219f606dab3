"""The families that alpha_by_n has no room for."""
from figures import alpha_by_n

TITLE = f"{alpha_by_n.TITLE}: further families"
IS_FOLDED = True


def draw(results, layout):
    return alpha_by_n.draw(results, layout, further=True)


def caption(results):
    return alpha_by_n.caption(results, further=True)
