// A corridor that a left-to-right sweep triangulates badly, for good as far as flips are concerned (F3).
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo flip_corridor_entry();

/// k = n - 4 points p_0 .. p_{k-1}, then v and w_0, of the standard corridor (greedy_corridor.h), then w_1 and w_2 at
/// x = k - .99 and x = k on the curve (1 + x, -eta / x); all with x negated, so that a sweep meets w_2 first.
///
/// Why it is bad: the sweep joins every p_i to w_2, at distance k; flips shorten a few edges but the fan is locally
/// optimal, because each of its quadrilaterals has its shorter diagonal or is not convex. The optimum joins the p_i to
/// w_0 and has O(1) edges of length k: alpha of order n.
/// Precondition: 6 <= n <= kMaxFlipCorridor. Correctly rounded operations only. O(n).
[[nodiscard]] std::vector<Point> flip_corridor_points(Index n);

/// As for the standard corridor.
inline constexpr Index kMaxFlipCorridor = 200'000;

}  // namespace mwt
