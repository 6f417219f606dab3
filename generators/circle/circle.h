// The regular polygon.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo circle_entry();

/// The vertices of the regular n-gon inscribed in the unit circle, counter-clockwise from (1, 0), correctly rounded but
/// for about one in a million. The same on every platform. O(n).
///
/// Precondition: 3 <= n <= kMaxRegularPolygon. Postcondition: in strictly convex position. With a = 2 pi / n, three
/// neighbours span twice the area 2 sin a (1 - cos a), about a^3; rounding moves each by at most 2^-53.5 and so changes
/// that by at most 4a 2^-53.5, which is less for a > 1.8e-8, n < 3.4e8.
[[nodiscard]] std::vector<Point> regular_polygon(Index n);

inline constexpr Index kMaxRegularPolygon = 100'000'000;

}  // namespace mwt
