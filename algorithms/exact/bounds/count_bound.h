// A lower bound from the points alone: how many edges a triangulation has, how few of them can be short, and what the
// triangles beside certain edges cost.
#pragma once

#include "algorithms/deadline.h"
#include "geometry/point.h"

namespace mwt {

/// Certified: no triangulation of the points is lighter.
///
/// A triangulation T has 3n - 3 - h edges, at most 3m - 6 between m points of a set. Minimum weight triangulations
/// contain the hull and the beta-skeleton (division/beta_skeleton.h). Let d(v) be the distance from v to its k-th
/// nearest neighbour, k = 10, and let v_1, v_2, ... ascend by d. Of the other edges of T whose ends are among the first
/// m, there are at most 3m - 6 less those of hull and skeleton there; and an edge from v_m to an earlier one is a pair
/// of which one is among the k nearest of the other, or at least d(v_m) long. Edges that obey these counts are lightest
/// if they are taken greedily (a matroid): m by m, the shortest of those allowed.
///
/// The triangles at the sides of hull and skeleton (side_costs.h) have long sides where chains of points face each
/// other or a far point. Both are counted: for some c, the part of each length above c as described, the part up to c
/// by these triangles. PROOFS.md has the argument.
///
/// 70 to 80% of the optimum on random points, clustered or not. O(n log n): a Delaunay triangulation, a search for k
/// neighbours of every point and one beside every certain edge, on the threads of the enclosing task arena. Where the
/// deadline passes before, the bound is the length of hull and skeleton, or simple_lower_bound().
[[nodiscard]] double bound_by_counts(Points points, const Deadline& deadline);

}  // namespace mwt
