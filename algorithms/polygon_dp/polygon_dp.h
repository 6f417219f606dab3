// The O(h^3) interval dynamic program of the source report (section 5.2, step 3): an optimal triangulation of a
// polygon.
#pragma once

#include <span>

#include "algorithms/algorithm.h"

namespace mwt {

/// What is minimised. The optimal triangulations are the same, since the sum of perimeters is twice the weight less the
/// polygon's length.
enum class PolygonObjective {
  edges,      ///< the weight: every edge once, the polygon's own edges included
  perimeter,  ///< the source report's cost: the triangles' perimeters, so that diagonals count twice
};

struct PolygonTriangulation {
  std::vector<Triangle> triangles;  ///< n - 2, counter-clockwise
  Interval cost;                    ///< certified bounds on the least cost; relative width about 1e-16
};

/// An optimal triangulation of a simple polygon, convex or not, given as a counter-clockwise cycle of indices. Vertices
/// on straight parts of the boundary are vertices like others; no triangle is flat and no edge passes through a vertex.
///
/// Intervals (i, j) of positions in the cycle, each after those inside it, as in the source report: the triangle
/// (i, k, j) on chord ij costs what its sides add. The first k wins ties (of costs that agree to about 100 bits).
/// Triangles are listed in preorder: (i, k, j), then those of (i, k), then those of (k, j), starting with the whole
/// cycle.
///
/// No visibility test is needed, only that every triangle turns left: the triangles' boundaries add up to the polygon,
/// which winds once around its inside and not at all around the rest; winding numbers of left-turning triangles are not
/// negative, so they cover the inside once. A vertex in the middle of a diagonal would be covered by its own triangles
/// as well.
///
/// Costs are double-double sums with a proven error bound; plain doubles only discard what is certainly worse.
/// Throws InputError if there is no triangulation: the cycle is not simple, not counter-clockwise, or flat.
/// O(n^3) time (about 0.2 s at n = 1000, 1.5 s at 2000), 16 n^2 bytes. Deterministic.
///
/// P. D. Gilbert, "New results in planar triangulations", 1979; G. T. Klincsek, "Minimal triangulations of polygonal
/// domains", Annals of Discrete Mathematics 9 (1980).
[[nodiscard]] PolygonTriangulation triangulate_polygon(Points points, std::span<const Index> polygon,
                                                       PolygonObjective objective);

/// Registry entry: the points themselves as polygon, by triangulate_convex_polygon() (convex_polygon.h) at any size.
/// NotApplicable unless all of them lie on the hull's boundary. Exact: with objective=edges the solution carries the
/// optimum. Where the deadline or memory stops it, the triangulation is the lightest that heuristics find as well
/// (common/lightest_heuristic.h).
[[nodiscard]] AlgorithmInfo polygon_dp_entry();

}  // namespace mwt
