// Points in the order of an implicit k-d tree: neighbours in the plane become neighbours in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/point.h"

namespace mwt {

/// An axis-parallel box.
struct Box {
  double min_x = 0;
  double min_y = 0;
  double max_x = 0;
  double max_y = 0;
};

/// A balanced k-d tree without pointers. Node 1 is the root, node i has children 2i and 2i + 1; the leaf_count leaves
/// are the nodes leaf_count .. 2 leaf_count - 1, a power of two chosen so that each holds kMinLeaf .. kMaxLeaf
/// points (the only leaf of a small tree may hold fewer). A node's points are contiguous, and where they begin and end
/// follows from its number alone.
struct KdOrder {
  static constexpr std::uint32_t kMinLeaf = 8;
  static constexpr std::uint32_t kMaxLeaf = 2 * kMinLeaf;  ///< so that a vector of 16 holds a leaf

  std::vector<Point> points;    ///< the instance, reordered
  std::vector<Index> original;  ///< their positions in the instance
  std::uint32_t leaf_count = 1;
  std::vector<Box> boxes;  ///< tight box of each node's points, by node number; boxes[0] is unused

  /// First point of a node; its points end where those of the next node of its level begin.
  [[nodiscard]] Index first_of(std::uint32_t node) const {
    const int level = 31 - __builtin_clz(node);
    return static_cast<Index>((static_cast<std::uint64_t>(points.size()) * (node - (1U << level))) >> level);
  }
  [[nodiscard]] Index last_of(std::uint32_t node) const {
    const int level = 31 - __builtin_clz(node);
    return static_cast<Index>((static_cast<std::uint64_t>(points.size()) * (node + 1 - (1U << level))) >> level);
  }
  [[nodiscard]] bool is_leaf(std::uint32_t node) const { return node >= leaf_count; }
};

/// Splits each node's points at their median across the longer side of their box; ties by the other coordinate, so that
/// the order is a function of the points alone. O(n log n); runs on the threads of the enclosing task arena.
[[nodiscard]] KdOrder make_kd_order(Points points);

}  // namespace mwt
