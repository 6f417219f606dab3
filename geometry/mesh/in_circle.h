// Whether a point lies inside a circle, filtered for speed: the Delaunay construction calls it ten times per point.
#pragma once

#include <cmath>

#include "geometry/numbers/trusted_range.h"
#include "geometry/point.h"
#include "geometry/predicates.h"

namespace mwt {

namespace detail {
/// Of the permanent: Shewchuk's bound is (10 + 96 * 2^-53) 2^-53 < 1.12e-15. With lifts of at most kMaxLifts, products
/// that underflow are off by 1e-222 in all: less than the 8e-17 * kMinPermanent that is left.
inline constexpr double kInCircleError = 1.2e-15;
inline constexpr double kMinPermanent = 1e-200;
inline constexpr double kMaxLifts = 1e100;

int in_circle_slow(const Point& a, const Point& b, const Point& c, const Point& d);
}  // namespace detail

/// As in_circle() of geometry/predicates.h: +1 if d lies inside the circle through a, b, c (counter-clockwise), -1 if
/// outside, 0 if on it. Exact. Coordinates that share a grid of 30 bits are decided in integers, others by that
/// function.
[[nodiscard]] inline int fast_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double adx = a.x - d.x, ady = a.y - d.y, bdx = b.x - d.x, bdy = b.y - d.y, cdx = c.x - d.x, cdy = c.y - d.y;
  const double bc1 = bdx * cdy, bc2 = bdy * cdx, ca1 = cdx * ady, ca2 = cdy * adx, ab1 = adx * bdy, ab2 = ady * bdx;
  const double a_lift = adx * adx + ady * ady, b_lift = bdx * bdx + bdy * bdy, c_lift = cdx * cdx + cdy * cdy;
  const double determinant = a_lift * (bc1 - bc2) + b_lift * (ca1 - ca2) + c_lift * (ab1 - ab2);
  const double permanent = a_lift * (std::abs(bc1) + std::abs(bc2)) + b_lift * (std::abs(ca1) + std::abs(ca2)) +
                           c_lift * (std::abs(ab1) + std::abs(ab2));
  if (std::abs(determinant) > detail::kInCircleError * permanent && permanent > detail::kMinPermanent &&
      a_lift + b_lift + c_lift < detail::kMaxLifts) {
    return determinant > 0 ? 1 : -1;
  }
  return detail::in_circle_slow(a, b, c, d);
}

}  // namespace mwt
