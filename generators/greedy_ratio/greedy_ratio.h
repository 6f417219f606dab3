// A corridor on which greedy's alpha tends to a chosen number (F1b).
#pragma once

#include <vector>

#include "generators/generator.h"
#include "generators/greedy_corridor/greedy_corridor.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo greedy_ratio_entry();

/// The corridor with m = 1 whose points p_i greedy joins to w_1 at distance 1 + beta + 1 - epsilon from them, the
/// optimum to w_0 at distance 1 + beta: beta makes the quotient alpha. Precondition: 1 < alpha <= 1.5.
[[nodiscard]] CorridorShape ratio_corridor(double alpha);

/// n points, in the order of corridor_points(): the same on every platform, O(n).
///
/// Why it works: |v w_1| = beta + 1 - epsilon < 1 + beta, the distance from p_i to w_0, so greedy takes v w_1 before
/// any p_i w_0 and every p_i must reach w_1. As n grows, the n - 3 edges of the p_i outweigh all others.
/// Preconditions: n >= 5, 1 < alpha <= 1.5.
[[nodiscard]] std::vector<Point> greedy_ratio_points(Index n, double alpha);

/// Largest n whose rounded chain is strictly convex: as for the standard corridor, but slope_end - slope_start is .01.
inline constexpr Index kMaxGreedyRatio = 100'000;

}  // namespace mwt
