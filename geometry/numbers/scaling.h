// Points brought into the range where floating-point filters work, without changing anything else.
#pragma once

#include <vector>

#include "geometry/numbers/interval.h"
#include "geometry/point.h"

namespace mwt {

/// The exponent e for which dividing all coordinates by 2^e brings the largest magnitude into [1, 2) and loses no bit
/// of any coordinate; 0 if the coordinates are near enough to 1 as they are (up to 2^100 and from 2^-100), or if bits
/// would be lost because they span too many magnitudes. O(n).
///
/// Dividing by a power of two changes no orientation, no comparison of lengths and no circle: an algorithm may work on
/// the quotients and return what it finds. Around 1e300 and 1e-300 products over- and underflow, so that every
/// predicate would have to fall back to multiple precision; among denormals lengths themselves lose their digits.
///
/// Afterwards, and with an exponent of 0, some coordinate is at least 2^-100. Unless all points lie on one line, two
/// differ in it, and so by the spacing of doubles there, 2^-153 or more: lengths that underflow are nothing to the
/// weight.
[[nodiscard]] int exact_scale(Points points);

/// The point divided by 2^e.
[[nodiscard]] Point scaled_down(const Point& p, int e);

/// All points divided by 2^exact_scale(points).
[[nodiscard]] std::vector<Point> exactly_scaled(Points points);

/// Bounds times 2^e: what holds of lengths between points that were divided by it. Rounded outwards where the result
/// is denormal or overflows.
[[nodiscard]] Interval scaled_up(const Interval& bounds, int e);

}  // namespace mwt
