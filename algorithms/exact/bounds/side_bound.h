// A lower bound for a face from the triangles at the sides of its boundary, when there is no time for more.
#pragma once

#include "algorithms/exact/faces/face_region.h"

namespace mwt {

/// Certified: no triangulation of the region by candidates has a smaller total length of diagonals.
///
/// Every directed side of the boundary has one triangle on its left. Let w(t) be half the length of the sides of
/// triangle t that are diagonals, and k(t) the number of the others: the diagonals are as long as the sum of all w(t),
/// which is at least the sum over the boundary's sides of the least w(t) / k(t) that a triangle of candidates has
/// there. Near the optimum where chains face each other; far below it where triangles cut off corners. Points within
/// triangles are not looked for, unless all three sides are the boundary's. O(sum over the sides of the candidates at
/// their ends).
[[nodiscard]] double bound_by_sides(Points points, const FaceRegion& region);

}  // namespace mwt
