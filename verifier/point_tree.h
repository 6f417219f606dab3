// A k-d tree over the points, to find those in a convex region without looking at all.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/point.h"

namespace mwt::verifier {

struct Box {
  double min_x, min_y, max_x, max_y;
};

/// Whether every point of the box certainly lies right of the directed line through a and b.
[[nodiscard]] bool lies_right(const Box& box, const Point& a, const Point& b);

/// A complete binary tree: node 1 is the root, node i has the children 2i and 2i + 1, and a node's points are halved
/// between its children down to kLeaf points.
class PointTree {
 public:
  static constexpr std::size_t kLeaf = 8;

  /// The points must stay alive. O(n log n).
  explicit PointTree(Points points);

  struct Node {
    std::size_t number, begin, end;  ///< points_in_order()[begin .. end)
    [[nodiscard]] bool is_leaf() const { return end - begin <= kLeaf; }
    [[nodiscard]] Node left() const { return {2 * number, begin, (begin + end) / 2}; }
    [[nodiscard]] Node right() const { return {2 * number + 1, (begin + end) / 2, end}; }
  };
  [[nodiscard]] Node root() const { return {1, 0, order_.size()}; }
  [[nodiscard]] std::size_t node_count() const { return boxes_.size(); }  ///< numbers are smaller
  [[nodiscard]] const Box& box(const Node& node) const { return boxes_[node.number]; }
  [[nodiscard]] const std::vector<Index>& points_in_order() const { return order_; }

  /// Visits every point in a box that is not skipped, until visit(point) returns true; returns whether it did.
  template <class Skip, class Visit>
  bool search(const Skip& skip, const Visit& visit) const {
    return search(root(), skip, visit);
  }

  /// Whether no point but its corners lies in the counter-clockwise triangle, boundary included.
  [[nodiscard]] bool is_empty(Index a, Index b, Index c) const;

 private:
  void build(const Node& node);

  template <class Skip, class Visit>
  bool search(const Node& node, const Skip& skip, const Visit& visit) const {
    if (skip(box(node))) return false;
    if (!node.is_leaf()) return search(node.left(), skip, visit) || search(node.right(), skip, visit);
    for (std::size_t i = node.begin; i < node.end; ++i) {
      if (visit(order_[i])) return true;
    }
    return false;
  }

  Points points_;
  std::vector<Index> order_;
  std::vector<Box> boxes_;
};

}  // namespace mwt::verifier
