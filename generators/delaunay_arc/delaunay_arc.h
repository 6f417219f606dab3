// A short arc and a point near its centre: the Delaunay triangulation is the fan of all radii (F2).
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo delaunay_arc_entry();

/// k = n - 1 points a_i = (-cos t_i, sin t_i) on an arc of the unit circle, t_i from -2 pi / 400 to 2 pi / 400 in equal
/// steps, and b = (.5, 0) last.
///
/// Why it is bad: b lies inside the circle, so the circle through a_i, a_{i+1}, b holds no other a_j, and the Delaunay
/// triangulation joins every a_i to b, over a distance of 1.5; the optimum triangulates the arc, of length .03, within
/// itself. D. G. Kirkpatrick, "A note on Delaunay and optimal triangulations", IPL 10 (1980), gives the theory (factor
/// of order n). In convex position: the optimum follows from the polygon program.
/// Precondition: 4 <= n <= kMaxArc. Correctly rounded operations only: the same on every platform. O(n).
[[nodiscard]] std::vector<Point> delaunay_arc_points(Index n);

/// The same with exact integers: (i^2, M i) for n - 1 consecutive i around 0, with M = 1024 K, K the largest |i|, and
/// then (M^2 / 2, 0), the centre of curvature of the vertex of the parabola on which the others lie.
/// Precondition: 4 <= n <= kMaxIntegerArc.
[[nodiscard]] std::vector<Point> integer_delaunay_arc_points(Index n);

/// With steps of a = pi / (100 n), three neighbours are off a line by about a^2, and neighbours' circles through b miss
/// the next point by about a^2; rounding moves points by 2^-53.
inline constexpr Index kMaxArc = 500'000;

/// M^2 / 2 = 2^19 K^2 <= 2^53 and n <= 2 K + 2.
inline constexpr Index kMaxIntegerArc = 262'146;

}  // namespace mwt
