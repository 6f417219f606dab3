// The Delaunay time beside a run: what CGAL's Delaunay triangulation of the same points takes, here and now.
#pragma once

#include "geometry/point.h"

namespace mwt {

/// Median seconds of up to seven measure_delaunay_time_s(); fewer, but at least one, once half a second is spent.
/// These are CPU times: what other programs took is not in them. Preconditions as there.
[[nodiscard]] double delaunay_time_s(Points points);

}  // namespace mwt
