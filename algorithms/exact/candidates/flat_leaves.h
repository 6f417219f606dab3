// The diamond test for whole boxes of points, where points lie almost on a line.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "algorithms/exact/candidates/diamond_kernels.h"
#include "algorithms/exact/candidates/kd_order.h"
#include "algorithms/exact/candidates/near_points.h"

namespace mwt {

/// Along a line no direction bin decides, because a point in an edge's own bin may lie on either side of it: every pair
/// would have to be tested. But a near point z may lie to the left of all edges from a point p into a far box, at an
/// angle below the diamond test's and at less than half their length: inside the left triangle of each. If another
/// does so on the right, no edge from p into the box is in a minimum weight triangulation.
///
/// One leaf after the other; holds the search for its near points.
class FlatLeafTest {
 public:
  explicit FlatLeafTest(const KdOrder& order) : order_(order), finder_(order), scale_(distance_scale(order)) {}

  /// `farthest`: no edge leaves a point of the leaf that is longer, in scaled units.
  void start(std::uint32_t leaf, float farthest);

  /// The points near the leaf, found when they are first asked for. Valid until the next start().
  [[nodiscard]] const NearPoints& near();

  /// Of the leaf's points in the mask (bit i: the i-th one), those that may have an edge into the node's box. All of
  /// them, unless the box is far away along the line that the near points almost lie on.
  ///
  /// Near points within a 1024th of their extent of that line make the leaf flat. O(1) for others; else O(near points)
  /// for each point, mostly less.
  [[nodiscard]] std::uint32_t with_edges_into(std::uint32_t node, std::uint32_t mask);

 private:
  // Which side of every edge from p into the box has z inside its triangle: 1 left, -1 right, 0 none that is sure.
  [[nodiscard]] int side_of(const Point& z, const Point& p, const Box& box) const;
  [[nodiscard]] bool is_excluded(std::size_t place, const Box& box);
  [[nodiscard]] bool is_along(const Box& box) const;
  void find_line();

  const KdOrder& order_;
  NearPointsFinder finder_;
  double scale_;
  const NearPoints* near_ = nullptr;
  std::uint32_t leaf_ = 1;
  std::optional<bool> is_flat_;                                     // false as well if no edge is long enough
  Point along_;                                                     // the line's direction
  std::array<std::array<std::size_t, 2>, KdOrder::kMaxLeaf> last_;  // places that decided about each point before
};

}  // namespace mwt
