// Points on a parabola.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo parabola_entry();

/// (i, i^2), i = 0 .. n - 1. Exact integers in strictly convex position.
///
/// Why it is bad: the Delaunay triangulation is the fan of all edges from (0, 0), because the circle through (0, 0) and
/// two neighbours meets the parabola a fourth time on the other side of the axis; the optimum cuts corners.
/// Precondition: 3 <= n <= kMaxParabola. O(n).
[[nodiscard]] std::vector<Point> parabola_points(Index n);

/// (n - 1)^2 <= 2^53.
inline constexpr Index kMaxParabola = 94'906'266;

}  // namespace mwt
