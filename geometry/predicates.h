// Exact geometric decisions for arbitrary finite doubles.
//
// Properties, for all inputs, however large, tiny or degenerate:
//   (1) every answer is that of real arithmetic on the given doubles: no tolerance, no rounding;
//   (2) orientation(a, b, c) is invariant under rotation of its arguments and changes sign under their exchange;
//   (3) a cheap floating-point filter with a proven error bound decides almost always; what it leaves open goes to
//       CGAL's exact kernel (in predicates.cpp, so that including this header stays light).
#pragma once

#include <cmath>

#include "geometry/numbers/trusted_range.h"
#include "geometry/point.h"

namespace mwt {

namespace detail {
int orientation_exact(const Point& a, const Point& b, const Point& c);
int compare_length_exact(const Point& a, const Point& b, const Point& c, const Point& d);
int dot_sign_exact(const Point& a, const Point& apex, const Point& b);
}  // namespace detail

/// +1 if a, b, c make a left turn (counter-clockwise), -1 for a right turn, 0 if they are collinear.
[[nodiscard]] inline int orientation(const Point& a, const Point& b, const Point& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  const double magnitude = std::abs(left) + std::abs(right);
  // Shewchuk's bound is (3 + 16 * 2^-53) 2^-53 < 3.34e-16.
  if (std::abs(determinant) > 4e-16 * magnitude && is_trusted_product(magnitude)) {
    return determinant > 0 ? 1 : -1;
  }
  return detail::orientation_exact(a, b, c);
}

/// Sign of |ab| - |cd|.
[[nodiscard]] inline int compare_length(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double abx = a.x - b.x, aby = a.y - b.y, cdx = c.x - d.x, cdy = c.y - d.y;
  const double ab = abx * abx + aby * aby;
  const double cd = cdx * cdx + cdy * cdy;
  // Each side errs by at most 4 rounding errors of itself: 4 * 2^-53 < 4.5e-16 of it.
  if (std::abs(ab - cd) > 1e-15 * (ab + cd) && is_trusted_product(ab + cd)) return ab > cd ? 1 : -1;
  return detail::compare_length_exact(a, b, c, d);
}

/// Sign of the scalar product (a - apex) . (b - apex): positive for an acute angle at apex, 0 for a right one.
[[nodiscard]] inline int dot_sign(const Point& a, const Point& apex, const Point& b) {
  const double x = (a.x - apex.x) * (b.x - apex.x);
  const double y = (a.y - apex.y) * (b.y - apex.y);
  const double magnitude = std::abs(x) + std::abs(y);
  // As for orientation.
  if (std::abs(x + y) > 4e-16 * magnitude && is_trusted_product(magnitude)) return x + y > 0 ? 1 : -1;
  return detail::dot_sign_exact(a, apex, b);
}

/// +1 if d lies inside the circle through a, b, c (counter-clockwise), -1 if outside, 0 if on it.
[[nodiscard]] int in_circle(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether p lies on segment ab, its ends excluded.
[[nodiscard]] bool in_segment_interior(const Point& p, const Point& a, const Point& b);

/// Whether segments ab and cd cross: their interiors meet, they overlap along a line, or one passes through an end of
/// the other. Segments that only share an end do not cross. Precondition: a != b, c != d.
[[nodiscard]] bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether a, b, c, d is a strictly convex quadrilateral in counter-clockwise order (no angle of 180 degrees).
[[nodiscard]] inline bool is_strictly_convex(const Point& a, const Point& b, const Point& c, const Point& d) {
  return orientation(a, b, c) > 0 && orientation(b, c, d) > 0 && orientation(c, d, a) > 0 && orientation(d, a, b) > 0;
}

/// Whether p lies in the counter-clockwise triangle abc, boundary (and so its corners) included.
[[nodiscard]] inline bool in_closed_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

}  // namespace mwt
