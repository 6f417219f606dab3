// First stage of the exact solver: all edges that the diamond test leaves.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/exact/candidates/diamond_kernels.h"
#include "algorithms/exact/candidates/kd_order.h"

namespace mwt {

/// Candidate edges, filed by blocks of neighbouring points: block b holds the points of one node of the k-d tree, and
/// its pairs are those whose smaller index is among them.
struct CandidateBlocks {
  static constexpr std::uint32_t kLeavesPerBlock = 128;  ///< about 1,500 points: their stars fit into a core's cache

  std::uint32_t first_block_node = 1;             ///< block b is node first_block_node + b
  std::vector<std::vector<CandidatePair>> inner;  ///< both ends in the block
  std::vector<std::vector<CandidatePair>> outer;  ///< the larger end in a later block

  [[nodiscard]] std::uint32_t block_count() const { return static_cast<std::uint32_t>(inner.size()); }
};

/// More candidates are not made: stars and faces would take some 50 bytes for each.
[[nodiscard]] constexpr std::size_t max_candidates(std::size_t n) { return std::max<std::size_t>(30'000'000, 64 * n); }

/// Finds a superset of the edges of every minimum weight triangulation (up to edges through a point, see below):
/// about 11.6 edges per uniformly distributed point.
///
/// Properties of the candidates:
///   (1) an edge is left out only if points certainly lie inside both of its diamond triangles, or a point exactly on
///   it; (2) an edge much longer than the near points reach, or than the distance to an end's nearest neighbour, is
///   tested against all points (long_edges.h); (3) a shorter one through a point may still be included if that point is
///   not among the near ones; (4) the result does not depend on the number of threads.
/// Time O(n log n) on inputs whose local density varies gradually or in clusters; up to O(n^2) in convex position,
/// where all edges pass the test. Runs on the threads of the enclosing task arena.
class DiamondTest {
 public:
  /// Computes, for every point and direction, the distance beyond which no edge survives.
  explicit DiamondTest(const KdOrder& order);

  /// The points that may lie on the convex hull's boundary: those with a direction that nothing nearby blocks.
  [[nodiscard]] std::vector<Index> possible_hull_points() const;

  /// Throws SearchStopped (search_stopped.h) after the context's deadline, or when the edges exceed max_candidates().
  [[nodiscard]] CandidateBlocks find_candidates(const Context& context) const;

 private:
  [[nodiscard]] bool may_connect(std::uint32_t leaf, std::uint32_t node) const;
  void collect_partners(std::uint32_t leaf, std::vector<std::uint32_t>& partners) const;
  template <class Check>
  void search_block(CandidateBlocks& blocks, std::uint32_t block, const Check& check) const;
  [[nodiscard]] bool is_long(const CandidatePair& pair, float reach) const;
  [[nodiscard]] float scaled_square(Index p, Index q) const;
  void find_nearest(std::uint32_t leaf);
  void set_maximum(std::uint32_t node, std::span<const DeadDistances> parts);

  const KdOrder& order_;
  double scale_;
  std::vector<float> nearest_square_;  ///< squared scaled distance of each point's nearest neighbour in its leaf
  std::vector<DeadDistances> dead_;
  std::vector<DeadDistances> dead_of_node_;  ///< maxima over a node's points
};

}  // namespace mwt
