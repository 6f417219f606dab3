// Points brought into the range where floating-point filters work, without changing anything else.
#pragma once

#include <vector>

#include "geometry/point.h"

namespace mwt {

/// The exponent e for which dividing all coordinates by 2^e brings the largest magnitude into [1, 2) and loses no bit
/// of any coordinate; 0 if the coordinates are near enough to 1 as they are (up to 2^100 and from 2^-100), or if bits
/// would be lost because they span too many magnitudes. O(n).
///
/// Dividing by a power of two changes no orientation, no comparison of lengths and no circle: an algorithm may work on
/// the quotients and return what it finds. Around 1e300 and 1e-300 products over- and underflow, so that every
/// predicate would have to fall back to multiple precision.
[[nodiscard]] int exact_scale(Points points);

/// The point divided by 2^e.
[[nodiscard]] Point scaled_down(const Point& p, int e);

/// All points divided by 2^exact_scale(points).
[[nodiscard]] std::vector<Point> exactly_scaled(Points points);

}  // namespace mwt
