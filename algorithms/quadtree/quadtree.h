// The source report's quadtree method (section 5.4): small cells optimally, then all of them merged.
#pragma once

#include "algorithms/algorithm.h"

namespace mwt {

struct QuadtreeTriangulation {
  Triangulation triangulation;
  std::size_t leaves = 0;           ///< with at least one point
  std::size_t constraints = 0;      ///< edges of local triangulations
  std::size_t overfull_leaves = 0;  ///< at the greatest depth with more than `capacity` points
};

/// Splits the bounding square until cells hold at most `capacity` points (geometry/quadtree.h), takes the edges of a
/// minimum weight triangulation of each leaf's points (minimum_weight_edges()), and merges all leaves with one
/// constrained Delaunay triangulation of all points in which these edges are constraints.
///
/// The source report merges neighbouring cells recursively, each time by a constrained Delaunay triangulation of their
/// boundary points; that is done in one step here, since the constraints of all levels are the leaves' edges. Leaves
/// are disjoint convex cells, so no two of their edges cross and none passes through a point. A leaf at the quadtree's
/// greatest depth may hold more points than the capacity: its edges are those of its Delaunay triangulation.
///
/// Preconditions: distinct points, not all collinear; capacity from 1 to kMaxLeaf, otherwise InputError.
/// No guarantee is known. O(n log n + n 2^capacity) time expected, O(n) space. Deterministic, except for
/// context.phases, where the times of grid, leaves and merge go.
[[nodiscard]] QuadtreeTriangulation quadtree_triangulation(Points points, int capacity, Context& context);

/// Registry entry. Ignores the deadline.
[[nodiscard]] AlgorithmInfo quadtree_entry();

}  // namespace mwt
