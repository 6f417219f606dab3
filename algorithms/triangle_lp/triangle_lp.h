// The triangle program of Dantzig, Hoffman and Hu over all empty triangles of a point set.
#pragma once

#include "algorithms/algorithm.h"

namespace mwt {

/// A minimum weight triangulation as the lightest cover of the convex hull by empty triangles: see triangle_cover.h for
/// the model and its certification, empty_triangles.h for the degenerate rules. The Delaunay triangulation is where it
/// starts and what it returns when the deadline leaves no time for better.
///
/// Parameters: max_points.
///
/// Preconditions: at least 3 distinct points, not all collinear; NotApplicable beyond max_points.
///
/// Solution::optimum is always certified; of relative width kProvedRelativeWidth or less unless the deadline or
/// numerical trouble intervened.
///
/// Ties: whichever optimum the simplex method meets; deterministic without a deadline.
///
/// Time: polynomial while the relaxation is integral, as it nearly always is. Uniform points: 0.1 s for n = 100, 0.7 s
/// for n = 200. Circles and wheels of 100 points take seconds, a greedy corridor minutes: their optima are nearly tied.
///
/// Space: O(number of empty triangles), up to n^3 / 6 in convex position.
[[nodiscard]] Solution solve_triangle_program(Points points, Context& context);

[[nodiscard]] AlgorithmInfo triangle_lp_entry();

}  // namespace mwt
