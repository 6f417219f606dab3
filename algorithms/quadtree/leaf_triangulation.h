// Optimal triangulations of a handful of points, for the leaves of the quadtree.
#pragma once

#include <span>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// Most points that minimum_weight_edges() takes.
inline constexpr int kMaxLeaf = 10;

/// The edges of a minimum weight triangulation of the chosen points, as if there were no others; of points on a line
/// the edges between neighbours, of a single point none. By (a, b).
///
/// Shortest way from the lower to the upper hull through the paths that are monotone in lexicographic order; one step
/// puts a triangle above a path. Every triangulation is such a way, since some triangle can always come next. Costs are
/// sums in double-double; of triangulations whose weights agree to about 100 bits, the first one found is taken.
/// Precondition: 1 to kMaxLeaf distinct points. Exact predicates. O(m^2 2^m) time for m points. Deterministic.
///
/// V. Alvarez, R. Seidel, "A simple aggregative algorithm for counting triangulations of planar point sets and related
/// problems", SoCG 2013.
[[nodiscard]] std::vector<Edge> minimum_weight_edges(Points points, std::span<const Index> chosen);

}  // namespace mwt
