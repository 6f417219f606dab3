// A corridor between two reflex chains on which greedy's weight grows like sqrt n times the optimum (F1).
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo greedy_corridor_entry();

/// The corridor's numbers. With u_i = sigma i / (k - 1) and x_j = beta + j (1 - epsilon):
///   p_i = (u_i - sigma, height - slope_start u_i - (slope_end - slope_start) u_i^2 / (2 sigma)),   i = 0 .. k - 1,
///   v   = (1, 0),
///   w_j = (1 + x_j, -eta / x_j),                                                                   j = 0 .. m.
struct CorridorShape {
  double beta = 0;
  double epsilon = 0;
  double height = 0;
  double eta = 0;
  double slope_start = 0;
  double slope_end = 0;
  double sigma = 0;
  double density = 0;  ///< k is about density m^2
};

/// alpha of greedy: 1.85 at n = 16, 3.78 at 64, 17.6 at 1024, 37.1 at 4096, towards .64 sqrt n.
[[nodiscard]] CorridorShape standard_corridor();
/// Larger: 19.2 at n = 1024, about .6 sqrt n. Doubles carry fewer points of it.
[[nodiscard]] CorridorShape sharp_corridor();

/// p_0 .. p_{k-1}, v, w_0 .. w_m: n = k + m + 2 points.
///
/// Why it is bad: {p_i, v} and {w_j} are reflex chains that face each other, and |v w_{j+1}| < |p_i w_j| for all i, j.
/// So greedy takes v w_1, v w_2, .., v w_m and leaves every p_i to reach for the far w_m, while the optimum joins the
/// p_i to w_0 and fans p_0 to the w_j. Greedy's result is flip-optimal. C. Levcopoulos, "An Omega(sqrt n) lower bound
/// for the nonoptimality of the greedy triangulation", IPL 25 (1987), gives the theory; this set is the project's own.
/// Optimum at any n: no edge crosses a chain's edges, so it is a lattice path of cross edges from v w_0 to p_0 w_m plus
/// the optima of the two convex polygons {p_i, v} and {w_j}.
///
/// Preconditions: k >= 2, m >= 1. Correctly rounded operations only: the same on every platform. O(n).
[[nodiscard]] std::vector<Point> corridor_points(const CorridorShape& shape, Index k, Index m);

/// The m of a corridor with n points: floor((-1 + sqrt(1 + 4 density (n - 2))) / (2 density)); k is n - 2 - m.
[[nodiscard]] Index corridor_length(const CorridorShape& shape, Index n);

/// Largest n whose rounded chains are strictly convex. Along the p_i the second difference of y is
/// (slope_end - slope_start) sigma / (k - 1)^2, and rounding changes it by at most 4 units of 2^-55 (standard) or 2^-57
/// (sharp), which is less up to these n.
inline constexpr Index kMaxStandardCorridor = 200'000;
inline constexpr Index kMaxSharpCorridor = 150'000;

}  // namespace mwt
