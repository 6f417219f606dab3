// First stage of the exact solver: all edges that the diamond test leaves.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/exact/diamond_kernels.h"
#include "algorithms/exact/kd_order.h"

namespace mwt {

/// Candidate edges, filed by blocks of neighbouring points: block b holds the points of one node of the k-d tree, and
/// its pairs are those whose smaller index is among them.
struct CandidateBlocks {
  static constexpr std::uint32_t kLeavesPerBlock = 128;  ///< about 1,500 points: their stars fit into a core's cache

  std::uint32_t first_block_node = 1;             ///< block b is node first_block_node + b
  std::vector<std::vector<CandidatePair>> inner;  ///< both ends in the block
  std::vector<std::vector<CandidatePair>> outer;  ///< the larger end in a later block
  std::vector<bool> may_be_on_hull;               ///< by point: some direction is blocked by nothing nearby

  [[nodiscard]] std::uint32_t block_count() const { return static_cast<std::uint32_t>(inner.size()); }
};

/// A superset of the edges of every minimum weight triangulation (up to edges through a point, see below): about 11.6
/// edges per uniformly distributed point.
///
/// Properties:
///   (1) an edge is left out only if points certainly lie inside both of its diamond triangles, or a point exactly on
///   it; (2) an edge through a point may still be included if that point is not among the near ones; (3) the result
///   does not depend on the number of threads.
/// Time O(n log n) on inputs whose local density varies gradually or in clusters; up to O(n^2) in convex position,
/// where all edges pass the test. Runs on the threads of the enclosing task arena.
[[nodiscard]] CandidateBlocks find_diamond_candidates(const KdOrder& order);

}  // namespace mwt
