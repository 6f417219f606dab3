// Whether triangles of a set of points hold other points of it.
#pragma once

#include <vector>

#include "algorithms/exact/candidates/kd_order.h"
#include "geometry/point.h"

namespace mwt {

/// Searches in a k-d tree. Exact.
class TriangleEmptiness {
 public:
  /// Distinct points. O(n log n); runs on the threads of the enclosing task arena.
  explicit TriangleEmptiness(Points points);

  /// Whether the closed counter-clockwise triangle holds no point but its corners. O(log n + leaves that meet it).
  [[nodiscard]] bool is_empty(Index a, Index b, Index c) const;

 private:
  Points points_;
  KdOrder order_;
};

}  // namespace mwt
