// Convex hulls by the source report's two methods (section 6.3), collinear boundary points included.
#pragma once

#include <vector>

#include "geometry/point.h"

namespace mwt {

/// The hull's boundary in counter-clockwise order from the lexicographically smallest point, **every** point on the
/// boundary included, so that its size is the h of the counting formulas. Both functions return the same sequence.
///
/// Precondition: distinct points. Collinear points (or fewer than 3) give the points in lexicographic order, which is
/// no polygon: check with all_collinear() first where that matters. Exact: decided by predicates.h. O(n log n) time,
/// O(n) space. Deterministic.
///
/// R. L. Graham, "An efficient algorithm for determining the convex hull of a finite planar set", IPL 1 (1972).
[[nodiscard]] std::vector<Index> graham_scan(Points points);

/// A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", IPL 9 (1979).
[[nodiscard]] std::vector<Index> monotone_chain(Points points);

/// The hull by the faster of the two.
[[nodiscard]] inline std::vector<Index> convex_hull(Points points) { return monotone_chain(points); }

/// Whether no three points span a triangle. O(n).
[[nodiscard]] bool all_collinear(Points points);

}  // namespace mwt
