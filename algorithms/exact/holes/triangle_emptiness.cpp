#include "algorithms/exact/holes/triangle_emptiness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/predicates.h"

namespace mwt {

namespace {

// Whether the whole box surely lies strictly to the right of the line from p to q; with p as origin, so that small
// boxes near p are judged well.
bool lies_to_the_right(const Box& box, const Point& p, const Point& q) {
  const double ex = q.x - p.x, ey = q.y - p.y;
  const double x = ey > 0 ? box.min_x - p.x : box.max_x - p.x;  // the corner farthest to the left
  const double y = ex > 0 ? box.max_y - p.y : box.min_y - p.y;
  const double one = ex * y, two = ey * x;
  const double margin = 1e-15 * (std::abs(one) + std::abs(two)) + 1e-290;
  return one - two < -margin;
}

}  // namespace

TriangleEmptiness::TriangleEmptiness(Points points) : points_(points), order_(make_kd_order(points)) {}

bool TriangleEmptiness::is_empty(Index a, Index b, Index c) const {
  const Point &pa = points_[a], &pb = points_[b], &pc = points_[c];
  std::array<std::uint32_t, 64> stack{1};  // a path in the tree and its siblings
  std::size_t height = 1;
  while (height > 0) {
    const std::uint32_t node = stack[--height];
    const Box& box = order_.boxes[node];
    if (lies_to_the_right(box, pa, pb) || lies_to_the_right(box, pb, pc) || lies_to_the_right(box, pc, pa)) continue;
    if (!order_.is_leaf(node)) {
      stack[height++] = 2 * node + 1;
      stack[height++] = 2 * node;
      continue;
    }
    for (Index i = order_.first_of(node); i < order_.last_of(node); ++i) {
      const Index p = order_.original[i];
      if (p != a && p != b && p != c && in_closed_triangle(points_[p], pa, pb, pc)) return false;
    }
  }
  return true;
}

}  // namespace mwt
