"""Triangulations as SVG, for notebooks."""
import numpy

_WIDTH = 480  # pixels
_MAX_EDGES = 20_000  # more make a notebook slow
_MAX_MARKED = 500  # points that are drawn as discs


def svg(points, edges):
    """A picture of the edges, y upwards; of very many only as many as a page bears, with a note."""
    low, high = points.min(axis=0), points.max(axis=0)
    extent = numpy.maximum(high - low, 1e-300)
    scale = _WIDTH / extent.max()
    height = max(1.0, scale * extent[1])
    places = numpy.column_stack([(points[:, 0] - low[0]) * scale, height - (points[:, 1] - low[1]) * scale])
    shown = edges[:: max(1, -(-len(edges) // _MAX_EDGES))]
    path = "".join(f"M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}" for (x1, y1), (x2, y2) in places[shown])
    discs = "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2"/>' for x, y in places) if len(points) <= _MAX_MARKED else ""
    note = f"<title>{len(shown)} of {len(edges)} edges</title>" if len(shown) < len(edges) else ""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH + 8}" height="{height + 8:.0f}" '
        f'viewBox="-4 -4 {_WIDTH + 8} {height + 8:.1f}">{note}'
        f'<path d="{path}" fill="none" stroke="#0072b2" stroke-width="1"/>{discs}</svg>'
    )
