// A lower bound for faces that were left open: dual values on the sides of triangles, balanced edge by edge.
#pragma once

#include "algorithms/deadline.h"
#include "algorithms/exact/faces/face_region.h"

namespace mwt {

/// Certified: no triangulation of the region by candidates has a smaller total length of diagonals. At least 0.
///
/// Every side of the boundary has a dual value, every candidate one on one side and its negative on the other. For a
/// triangle t let r(t) be half the length of its sides that are candidates, less the dual values of its three sides.
/// The diagonals are as long as the boundary's dual values and the r(t) of a triangulation's triangles together
/// (Dantzig, Hoffman, Hu 1985). Dual values start at 0. Then, in rounds, the boundary's take the least r of the
/// triangles at their side, and every candidate passes dual value from one side to the other until the least r on both
/// are equal: no r becomes negative but by rounding, for which the bound pays.
///
/// The region may be several faces at once, and candidates may cross its boundary. O(triangles of candidates) per
/// round; no more than 2^23 triangles are listed, otherwise the bound is 0. Triangles that hold vertices of the region
/// are left out if the deadline leaves time to look; it stops the rounds as well, and the listing (then the bound is
/// 0).
[[nodiscard]] double balanced_bound(Points points, const FaceRegion& region, const Deadline& deadline);

}  // namespace mwt
