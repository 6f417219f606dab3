// A certified lower bound for when nothing better can be had.
#pragma once

#include "geometry/point.h"

namespace mwt {

/// No triangulation of the points is lighter: an interior point has at least three edges, one on the hull at least two,
/// none shorter than the distance to its nearest neighbour, which is a Delaunay neighbour; each edge counts at both
/// ends. O(n log n).
[[nodiscard]] double simple_lower_bound(Points points);

}  // namespace mwt
