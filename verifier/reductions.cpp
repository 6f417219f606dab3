#include "verifier/reductions.h"

#include <algorithm>
#include <cmath>

#include "verifier/exact.h"
#include "verifier/refused.h"

namespace mwt::verifier {

namespace {

// The cotangent of arcsin(1 / 1.17682), rounded up.
constexpr double kBetaCotangent = 0.620408;

}  // namespace

Reductions::Reductions(Points points, const PointTree& tree, EdgeSet candidates, const std::vector<Index>& hull)
    : points_(points), tree_(tree), candidates_(std::move(candidates)), certain_(points.size()) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Index a = hull[i], b = hull[(i + 1) % hull.size()];
    candidates_.insert(a, b);
    certain_.insert(a, b);
  }
}

// Whether a, right, b, left is strictly convex and its diagonal from left to right is shorter than that from a to b.
bool Reductions::is_flippable(Index a, Index b, Index left, Index right) const {
  const Point &l = points_[left], &r = points_[right];
  return compare_lengths(l, r, points_[a], points_[b]) < 0 && turn(l, r, points_[b]) > 0 && turn(r, l, points_[a]) > 0;
}

void Reductions::remove_not_minimal(Index a, Index b) {
  if (!candidates_.contains(a, b)) return;
  if (certain_.contains(a, b)) throw Refused("the edge is certain", {a, b});
  candidates_.common_neighbours(a, b, common_);
  left_.clear();
  right_.clear();
  for (const Index c : common_) {
    const int side = turn(points_[a], points_[b], points_[c]);
    if (side > 0) left_.push_back(c);
    if (side < 0) right_.push_back(c);
  }
  for (const Index l : left_) {
    for (const Index r : right_) {
      if (is_flippable(a, b, l, r) || !is_empty(a, b, l) || !is_empty(b, a, r)) continue;
      throw Refused("the edge between the first two is locally minimal between the others", {a, b, l, r});
    }
  }
  candidates_.erase(a, b);
}

void Reductions::remove_crossing(Index a, Index b, Index certain_a, Index certain_b) {
  if (!certain_.contains(certain_a, certain_b))
    throw Refused("the edge that is crossed is not certain", {certain_a, certain_b});
  if (certain_.contains(a, b) || !do_cross(points_[a], points_[b], points_[certain_a], points_[certain_b])) {
    throw Refused("the edge does not cross the certain one", {a, b, certain_a, certain_b});
  }
  candidates_.erase(a, b);
}

// Whether a candidate yw crosses st, s, y and w being the corners of an empty triangle of candidates.
bool Reductions::is_crossed_near(Index s, Index t) const {
  const Point &p = points_[s], &q = points_[t];
  std::vector<Index> common;
  for (const Index y : candidates_.star(s)) {
    if (turn(p, q, points_[y]) >= 0) continue;
    candidates_.common_neighbours(s, y, common);
    for (const Index w : common) {
      const bool is_between = turn(p, q, points_[w]) > 0 && turn(p, points_[y], points_[w]) > 0;
      const bool is_beyond = turn(points_[y], points_[w], q) < 0;
      if (is_between && is_beyond && is_empty(s, y, w)) return true;
    }
  }
  return false;
}

// Whether a point lies inside segment ab. The diamond test leaves no such candidate; here the theorem needs it.
bool Reductions::is_interrupted(Index a, Index b) const {
  const Point &p = points_[a], &q = points_[b];
  const auto skip = [&](const Box& box) {
    return box.min_x > std::max(p.x, q.x) || box.max_x < std::min(p.x, q.x) || box.min_y > std::max(p.y, q.y) ||
           box.max_y < std::min(p.y, q.y) || lies_right(box, p, q) || lies_right(box, q, p);
  };
  return tree_.search(skip, [&](Index i) { return i != a && i != b && is_inside_segment(points_[i], p, q); });
}

void Reductions::mark_uncrossed(Index a, Index b) {
  if (certain_.contains(a, b)) return;
  if (!candidates_.contains(a, b)) throw Refused("the edge is no candidate", {a, b});
  if (is_interrupted(a, b)) throw Refused("a point lies on the edge", {a, b});
  if (candidates_.star(b).size() < candidates_.star(a).size()) std::swap(a, b);
  if (is_crossed_near(a, b) && is_crossed_near(b, a)) throw Refused("candidates cross the edge at both ends", {a, b});
  certain_.insert(a, b);
}

Bounds Reductions::weight_of_certain() const {
  Bounds sum = 0;
  for (Index v = 0; v < points_.size(); ++v) {
    for (const Index to : certain_.star(v)) {
      if (v < to) sum += length(points_[v], points_[to]);
    }
  }
  return sum;
}

Bounds Reductions::bound_by_degrees(const std::vector<Index>& hull) const {
  std::vector<std::size_t> degree(points_.size(), 3);
  for (const Index v : hull) degree[v] = 2;
  Bounds twice = 0;
  for (Index v = 0; v < points_.size(); ++v) {
    std::vector<double> lengths;  // rounded down
    for (const Index to : candidates_.star(v)) lengths.push_back(lower_double(length(points_[v], points_[to])));
    require(lengths.size() >= degree[v], "a point has too few candidates", {v});
    std::partial_sort(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(degree[v]), lengths.end());
    for (std::size_t i = 0; i < degree[v]; ++i) twice += lengths[i];
  }
  return scaled(twice, -1);
}

void Reductions::mark_beta_skeleton(Index a, Index b) {
  if (certain_.contains(a, b)) return;
  const Point &p = points_[a], &q = points_[b];
  // The points that see the edge at this angle or a larger one lie within its length of its ends.
  const double reach = 1.2 * std::max(std::abs(q.x - p.x), std::abs(q.y - p.y)) * std::sqrt(2.0);
  const auto skip = [&](const Box& box) {
    return box.min_x > std::max(p.x, q.x) + reach || box.max_x < std::min(p.x, q.x) - reach ||
           box.min_y > std::max(p.y, q.y) + reach || box.max_y < std::min(p.y, q.y) - reach;
  };
  const auto sees_it_large = [&](Index i) {
    if (i == a || i == b) return false;
    // dot <= cotangent * |cross|
    return sign_of_form(points_[i], p, q, -kBetaCotangent, 1) <= 0 ||
           sign_of_form(points_[i], p, q, kBetaCotangent, 1) <= 0;
  };
  if (tree_.search(skip, sees_it_large)) throw Refused("a point sees the edge at a large angle", {a, b});
  candidates_.insert(a, b);
  certain_.insert(a, b);
}

}  // namespace mwt::verifier
