// Inserts points by splitting triangles, all of them at once: every triangle deals its points out to those it is split
// into.
#pragma once

#include <span>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

struct SplitTriangles {
  std::vector<Triangle> triangles;
  std::size_t edge_splits = 0;  ///< triangles split by a point on one of their sides: two per such point
  std::size_t depth = 0;        ///< the largest number of splits that led to one triangle
};

/// What inserting `interior`, in this order, makes of the list `triangles`: the triangle (a, b, c) that holds p is
/// replaced where it stands by (a, b, p), (b, c, p), (c, a, p). If p lies on a side, the triangles on both sides of it
/// are replaced, each where it stands, and the flat one of the three is left out.
///
/// What becomes of a triangle depends only on the points in it (boundary included) and their order. So each hands its
/// points on to the triangles into which the first of them splits it, as quicksort does, and the list comes out in
/// order. Before that, the polygon is cut along its triangulation in the same way. Where regions nest deeper than a few
/// times log2(n), their points go to SplitHistory, which does not mind depth, as heapsort takes over in introsort.
///
/// Preconditions: `triangles` triangulates the counter-clockwise `polygon` in the preorder of triangulate_polygon();
/// the points of `interior` are distinct, lie inside it and are none of its vertices. Exact predicates only. O(n log^2
/// n) time for any points and order, O(n) space. Deterministic.
[[nodiscard]] SplitTriangles insert_by_splitting(Points points, std::span<const Index> polygon,
                                                 std::span<const Triangle> triangles, std::span<const Index> interior);

}  // namespace mwt
