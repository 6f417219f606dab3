#include "verifier/point_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "verifier/exact.h"

namespace mwt::verifier {

namespace {

// In doubles, as exact.cpp reasons: a sum of two products of differences errs by less than 2^-49 of their magnitudes.
constexpr double kTurnRounding = 0x1p-49;

}  // namespace

bool lies_right(const Box& box, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  // cross(b - a, p - a) = dx * (p.y - a.y) - dy * (p.x - a.x) is largest in a corner.
  const double y = dx > 0 ? box.max_y - a.y : box.min_y - a.y;
  const double x = dy > 0 ? box.min_x - a.x : box.max_x - a.x;
  const double one = dx * y, other = dy * x, magnitude = std::abs(one) + std::abs(other);
  return magnitude > 1e-280 && magnitude < 1e300 && one - other < -kTurnRounding * magnitude;
}

PointTree::PointTree(Points points) : points_(points), order_(points.size()) {
  for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<Index>(i);
  boxes_.resize(2 * std::bit_ceil((order_.size() + kLeaf - 1) / kLeaf) + 2);
  build(root());
}

void PointTree::build(const Node& node) {
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(node.begin);
  const auto end = order_.begin() + static_cast<std::ptrdiff_t>(node.end);
  const auto [left, right] =
      std::minmax_element(begin, end, [&](Index p, Index q) { return points_[p].x < points_[q].x; });
  const auto [low, high] =
      std::minmax_element(begin, end, [&](Index p, Index q) { return points_[p].y < points_[q].y; });
  const Box box{points_[*left].x, points_[*low].y, points_[*right].x, points_[*high].y};
  boxes_[node.number] = box;
  if (node.is_leaf()) return;
  const bool is_wide = box.max_x - box.min_x > box.max_y - box.min_y;
  const auto middle = order_.begin() + static_cast<std::ptrdiff_t>((node.begin + node.end) / 2);
  std::nth_element(begin, middle, end, [&](Index p, Index q) {
    return is_wide ? points_[p].x < points_[q].x : points_[p].y < points_[q].y;
  });
  build(node.left());
  build(node.right());
}

bool PointTree::is_empty(Index a, Index b, Index c) const {
  const Point &p = points_[a], &q = points_[b], &r = points_[c];
  const auto skip = [&](const Box& box) {
    return lies_right(box, p, q) || lies_right(box, q, r) || lies_right(box, r, p);
  };
  const auto is_inside = [&](Index i) {
    const Point& s = points_[i];
    return i != a && i != b && i != c && turn(p, q, s) >= 0 && turn(q, r, s) >= 0 && turn(r, p, s) >= 0;
  };
  return !search(skip, is_inside);
}

}  // namespace mwt::verifier
