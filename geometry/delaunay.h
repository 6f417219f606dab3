// Delaunay triangulations by CGAL: only its source includes CGAL's triangulation headers.
#pragma once

#include <span>

#include "geometry/triangulation.h"

namespace mwt {

/// The Delaunay triangulation (cocircular ties as CGAL's insertion in spatial order resolves them: deterministic).
/// Preconditions: distinct points, not all collinear, otherwise InputError. Expected O(n log n) time.
[[nodiscard]] Triangulation delaunay_triangulation(Points points);

/// The constrained Delaunay triangulation: contains every edge of `constraints`, Delaunay elsewhere.
/// Preconditions: as above; no two constraints cross, none passes through a point, otherwise std::logic_error.
[[nodiscard]] Triangulation constrained_delaunay_triangulation(Points points, std::span<const Edge> constraints);

/// CPU seconds of one construction of CGAL's Delaunay triangulation. Precondition: at least one point.
[[nodiscard]] double time_delaunay_once_s(Points points);

/// The Delaunay time: processor seconds that CGAL::Delaunay_triangulation_2<Epick>(first, last) takes on `points`, one
/// thread, no vertex info, destruction excluded. One measurement, on few points the mean over a millisecond's worth;
/// callers take the median of seven interleaved ones.
[[nodiscard]] double measure_delaunay_time_s(Points points);

}  // namespace mwt
