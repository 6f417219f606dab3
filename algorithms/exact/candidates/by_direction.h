// The order of points around a center.
#pragma once

#include "geometry/predicates.h"

namespace mwt {

/// Compares points other than the center by direction: counter-clockwise from that of the positive x axis; equal
/// directions by distance. A strict weak order, exact.
class ByDirection {
 public:
  ByDirection(Points points, Index center) : points_(points), center_(points[center]) {}

  bool operator()(Index a, Index b) const {
    const bool a_is_below = is_below(points_[a]), b_is_below = is_below(points_[b]);
    if (a_is_below != b_is_below) return b_is_below;
    const int turn = orientation(center_, points_[a], points_[b]);
    if (turn != 0) return turn > 0;
    return a != b && in_segment_interior(points_[a], center_, points_[b]);
  }

  [[nodiscard]] bool is_same_direction(Index a, Index b) const {
    return orientation(center_, points_[a], points_[b]) == 0 && is_below(points_[a]) == is_below(points_[b]);
  }

 private:
  [[nodiscard]] bool is_below(const Point& p) const { return p.y < center_.y || (p.y == center_.y && p.x < center_.x); }

  Points points_;
  Point center_;
};

}  // namespace mwt
