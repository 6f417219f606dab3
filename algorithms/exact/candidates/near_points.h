// Gathers the points around a leaf of the k-d tree, which decide the diamond test for its edges.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/exact/candidates/diamond_kernels.h"
#include "algorithms/exact/candidates/kd_order.h"

namespace mwt {

/// The power of two that scales the tree's extent to [2^60, 2^61). Extents below 2^-940 stay smaller.
[[nodiscard]] double distance_scale(const KdOrder& order);

/// Lower bound of the scaled distance between two boxes, if it is at least kMinDistance; 0 if they touch.
[[nodiscard]] float box_distance(const Box& a, const Box& b, double scale);

/// Finds near points leaf by leaf; holds the space that the search needs.
class NearPointsFinder {
 public:
  explicit NearPointsFinder(const KdOrder& order) : order_(order) { near_.scale = distance_scale(order); }

  /// The NearPoints::kLeaves closest leaves. Valid until the next call.
  const NearPoints& find(std::uint32_t leaf);

  /// Adds samples from all over the tree, sparser with distance: 16 points of each ancestor's sibling.
  const NearPoints& add_samples(std::uint32_t leaf);

 private:
  void append_leaf(std::uint32_t leaf, float distance);
  void append_box(const Box& box);

  const KdOrder& order_;
  NearPoints near_;
  std::vector<std::pair<float, std::uint32_t>> queue_;
};

}  // namespace mwt
