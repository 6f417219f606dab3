// A lower bound from the candidates that the LMT-skeleton leaves, when there is no time to find out which are certain.
#pragma once

#include "algorithms/deadline.h"
#include "algorithms/exact/candidates/lmt_kernels.h"
#include "algorithms/exact/candidates/stars.h"
#include "geometry/point.h"

namespace mwt {

/// Certified: no triangulation by the stars' edges is lighter that contains the beta-skeleton
/// (division/beta_skeleton.h), as minimum weight triangulations do. balanced_bound() between the hull, the skeleton and
/// the other edges, which is 0 if the deadline passes or there are too many of them: then only the hull and the
/// skeleton count. O(n log n) and what balanced_bound() takes.
[[nodiscard]] double bound_by_stars(Points points, const HullEdges& hull, const StarTable& table,
                                    const Deadline& deadline);

}  // namespace mwt
