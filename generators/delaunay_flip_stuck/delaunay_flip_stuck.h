// A set whose Delaunay triangulation is bad and cannot be mended by flips (F4).
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo delaunay_flip_stuck_entry();

/// k = n - 4 points p_0 .. p_{k-1} on a flat arc of length 1/8 that ends in the origin, then v = (1, -.1 / L),
/// w_0 = (1.6, .1 / L), and w_1, w_2 at distance about L = 2 k in the direction of 30 degrees, .9 apart, on one circle
/// with v and (1.6, .2 / L).
///
/// Why it is bad: that circle passes just above w_0, so the Delaunay triangulation has the edge v w_1, which cuts the
/// p_i off from w_0 and makes them reach for the far w_1; the quadrilaterals in the way are not convex or would only
/// get longer diagonals, so flips do not help. The optimum joins the p_i to w_0: alpha of order n. Greedy finds it.
/// Precondition: 6 <= n <= kMaxDelaunayFlipStuck. Correctly rounded operations only: the same on every platform.
/// O(n).
[[nodiscard]] std::vector<Point> delaunay_flip_stuck_points(Index n);

inline constexpr Index kMaxDelaunayFlipStuck = 200'000;

}  // namespace mwt
