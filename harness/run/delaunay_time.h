// The Delaunay time beside a run: what CGAL's Delaunay triangulation of the same points takes, here and now.
#pragma once

#include "geometry/point.h"

namespace mwt {

/// Median seconds of up to 15 time_delaunay_once_s(), each after the branch history of the one before was overwritten,
/// as time_repeatedly() times runs; fewer, but at least one, once half a second is spent. These are CPU times: what
/// other programs took is not in them. Precondition: at least one point.
[[nodiscard]] double delaunay_time_s(Points points);

}  // namespace mwt
