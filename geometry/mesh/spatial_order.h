// An order of the points in which neighbours in the plane are mostly neighbours in memory.
#pragma once

#include <vector>

#include "geometry/point.h"

namespace mwt {

/// Indices 0 .. points.size() - 1 along a Hilbert curve through the points' bounding square.
///
/// Cells of the curve that hold several points are refined by a curve of their own, scaled to their points, so that
/// clusters and point sets whose distances span hundreds of decimal orders are ordered as finely as uniform ones.
/// Precondition: distinct finite points. O(n) time for spread 2^16 per level of refinement, O(n) space. Deterministic.
[[nodiscard]] std::vector<Index> spatial_order(Points points);

}  // namespace mwt
