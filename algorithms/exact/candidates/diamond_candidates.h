// First stage of the exact solver: all edges that the diamond test leaves.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/exact/candidates/diamond_kernels.h"
#include "algorithms/exact/candidates/flat_leaves.h"
#include "algorithms/exact/candidates/kd_order.h"

namespace mwt {

/// Blocks of neighbouring points: block b holds those of node count() + b of the k-d tree.
class PointBlocks {
 public:
  explicit PointBlocks(const KdOrder& order)
      : order_(order), count_(std::max(order.leaf_count / kLeavesPerBlock, 1U)), leaves_(order.leaf_count / count_) {}

  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] std::uint32_t node_of(std::uint32_t block) const { return count_ + block; }
  [[nodiscard]] std::uint32_t first_leaf_of(std::uint32_t block) const { return node_of(block) * leaves_; }
  [[nodiscard]] std::uint32_t last_leaf_of(std::uint32_t block) const { return first_leaf_of(block) + leaves_; }
  [[nodiscard]] std::uint32_t block_of_leaf(std::uint32_t leaf) const { return leaf / leaves_ - count_; }
  [[nodiscard]] std::uint32_t block_of(Index p) const;

 private:
  static constexpr std::uint32_t kLeavesPerBlock = 128;  // about 1,500 points: their stars fit into a core's cache

  const KdOrder& order_;
  std::uint32_t count_;
  std::uint32_t leaves_;  // of a block
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
/// where all edges pass the test.
///
/// The candidates are found block by block, for whoever works on one block at a time while it is in a core's cache:
/// those that leave blocks first, then those within each; all together would take some 100 bytes per point. They come
/// leaf by leaf, those of one leaf by the leaves of their larger ends, and so that each point's neighbours ascend.
/// These functions throw SearchStopped (search_stopped.h) after the context's deadline, and when the candidates found
/// exceed max_candidates().
class DiamondTest {
 public:
  /// Computes, for every point and direction, the distance beyond which no edge survives. Runs on the threads of the
  /// enclosing task arena.
  explicit DiamondTest(const KdOrder& order);

  [[nodiscard]] const PointBlocks& blocks() const { return blocks_; }

  /// The points that may lie on the convex hull's boundary: those with a direction that nothing nearby blocks.
  [[nodiscard]] std::vector<Index> possible_hull_points() const;

  /// For each block the candidates from its points to those of later blocks. Runs on the threads of the enclosing task
  /// arena.
  [[nodiscard]] std::vector<std::vector<CandidatePair>> find_outer(const Context& context);

  /// The candidates within a block, in place of what `found` holds. Once for each block, after find_outer(): what is
  /// known of the block's points is forgotten. For different blocks at the same time, too.
  void take_inner(std::uint32_t block, const Context& context, std::vector<CandidatePair>& found);

  /// How many have been found.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  struct Partner {
    std::uint32_t leaf;
    std::uint32_t open;  // the points of the leaf at hand that may have edges to it, by place
  };
  using Partners = std::vector<Partner>;

  void compute_dead_distances_of(std::uint32_t block);
  [[nodiscard]] std::span<const DeadDistances> dead_of_leaf(std::uint32_t leaf) const;
  [[nodiscard]] bool may_connect(std::uint32_t leaf, std::uint32_t node) const;
  template <class MayVisit>
  void collect_partners(std::uint32_t leaf, std::uint32_t root, const MayVisit& may_visit, FlatLeafTest& flat,
                        Partners& partners) const;
  template <class Collect>
  void search_block(std::uint32_t block, const Collect& collect, const Context& context,
                    std::vector<CandidatePair>& candidates);
  void add_to_count(std::size_t found, const Context& context);
  [[nodiscard]] bool is_long(const CandidatePair& pair, float reach) const;
  [[nodiscard]] float scaled_square(Index p, Index q) const;
  void find_nearest(std::uint32_t leaf);
  void set_maximum(std::uint32_t node, std::span<const DeadDistances> parts);

  const KdOrder& order_;
  PointBlocks blocks_;
  double scale_;
  std::vector<float> nearest_square_;  ///< squared scaled distance of each point's nearest neighbour in its leaf
  std::vector<std::vector<DeadDistances>> dead_;  ///< by block
  std::vector<DeadDistances> dead_of_node_;       ///< maxima over a node's points
  std::atomic<std::size_t> count_ = 0;
};

}  // namespace mwt
