// A triangulation and a certified lower bound for when nothing better can be had.
#pragma once

#include "geometry/interval.h"
#include "geometry/triangulation.h"

namespace mwt {

struct BoundedTriangulation {
  Triangulation triangulation;
  Interval optimum;
};

/// The Delaunay triangulation. Below: an interior point has at least three edges, one on the hull at least two, none
/// shorter than the distance to its nearest neighbour, which is a Delaunay neighbour; each edge counts at both ends.
/// O(n log n).
[[nodiscard]] BoundedTriangulation delaunay_with_lower_bound(Points points);

}  // namespace mwt
