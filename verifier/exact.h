// The verifier's geometric decisions: signs of polynomials in the coordinates, never rounded.
#pragma once

#include "geometry/point.h"

namespace mwt::verifier {

/// The sign of s * cross(a - o, b - o) + t * dot(a - o, b - o), for any finite doubles.
///
/// Evaluated in doubles first; where the result is not larger than what rounding may have done, in integers.
[[nodiscard]] int sign_of_form(const Point& o, const Point& a, const Point& b, double s, double t);

/// +1 if a, b, c turn left, -1 if they turn right, 0 if they are collinear.
[[nodiscard]] inline int turn(const Point& a, const Point& b, const Point& c) { return sign_of_form(a, b, c, 1, 0); }

/// The sign of |ab| - |cd|.
[[nodiscard]] int compare_lengths(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether p lies on segment ab, its ends excluded.
[[nodiscard]] bool is_inside_segment(const Point& p, const Point& a, const Point& b);

/// Whether the segments ab and cd cannot both be edges of a triangulation: their interiors meet, or one passes through
/// an end of the other. Segments that only share an end can.
[[nodiscard]] bool do_cross(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace mwt::verifier
