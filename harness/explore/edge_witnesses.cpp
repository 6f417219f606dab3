#include "harness/explore/edge_witnesses.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "geometry/numbers/scaling.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr std::uint64_t kMaxWork = std::uint64_t{1} << 28;

void insert_sorted(std::vector<Index>& values, Index value) {
  values.insert(std::lower_bound(values.begin(), values.end(), value), value);
}

void erase_sorted(std::vector<Index>& values, Index value) {
  const auto place = std::lower_bound(values.begin(), values.end(), value);
  if (place != values.end() && *place == value) values.erase(place);
}

// Of the angle at c over the edge ab.
double cosine_over(const Point& a, const Point& b, const Point& c) {
  const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
  return (ax * bx + ay * by) / (std::hypot(ax, ay) * std::hypot(bx, by));
}

}  // namespace

void CandidateStars::add(const Edge& edge) {
  insert_sorted(neighbours_[edge.a], edge.b);
  insert_sorted(neighbours_[edge.b], edge.a);
}

void CandidateStars::remove(const Edge& edge) {
  erase_sorted(neighbours_[edge.a], edge.b);
  erase_sorted(neighbours_[edge.b], edge.a);
}

EdgeWitnesses::EdgeWitnesses(Points points) : points_(exactly_scaled(points)), by_x_(points.size()) {
  std::iota(by_x_.begin(), by_x_.end(), Index{0});
  std::ranges::sort(by_x_, {}, [&](Index i) { return points_[i].x; });
  for (const Index i : by_x_) xs_.push_back(points_[i].x);
}

// The first of the points from `left` to `right` for which the test holds.
template <class Test>
Index EdgeWitnesses::find(double left, double right, const Test& test) {
  const auto begin = std::ranges::lower_bound(xs_, left);
  const auto end = std::upper_bound(begin, xs_.end(), right);
  for (auto x = begin; x != end; ++x) {
    ++work_;
    const Index i = by_x_[static_cast<std::size_t>(x - xs_.begin())];
    if (test(i)) return i;
  }
  return kNoIndex;
}

// side: 1 left, -1 right.
Index EdgeWitnesses::inside_half_diamond(const Edge& edge, double side) {
  constexpr double kMargin = 1e-9;
  static const double slope = std::tan(std::numbers::pi / 4.6);
  const Point a = points_[edge.a], b = points_[edge.b];
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double apex = (a.x + b.x) / 2 - side * dy * slope / 2;
  const auto [low, high] = std::minmax({a.x, b.x, apex});
  return find(low, high, [&](Index i) {
    const double px = points_[i].x - a.x, py = points_[i].y - a.y;
    const double along = (px * dx + py * dy) / squared, across = side * (dx * py - dy * px) / squared;
    return across > kMargin && across < slope * std::min(along, 1 - along) - kMargin;
  });
}

std::optional<EdgeWitnesses::Sides> EdgeWitnesses::in_diamond(const Edge& edge) {
  if (work_ > kMaxWork) return std::nullopt;
  return Sides{inside_half_diamond(edge, 1), inside_half_diamond(edge, -1)};
}

bool EdgeWitnesses::is_empty(const std::array<Index, 3>& triangle) {
  const Point &a = points_[triangle[0]], &b = points_[triangle[1]], &c = points_[triangle[2]];
  const auto [low, high] = std::minmax({a.x, b.x, c.x});
  const int turn = orientation(a, b, c);
  const Index inside = find(low, high, [&](Index i) {
    if (std::ranges::find(triangle, i) != triangle.end()) return false;
    const Point& p = points_[i];
    return turn * orientation(a, b, p) >= 0 && turn * orientation(b, c, p) >= 0 && turn * orientation(c, a, p) >= 0;
  });
  return inside == kNoIndex;
}

std::optional<EdgeWitnesses::Sides> EdgeWitnesses::apexes(const Edge& edge, const CandidateStars& candidates) {
  if (work_ > kMaxWork) return std::nullopt;
  const auto &of_a = candidates.neighbours(edge.a), &of_b = candidates.neighbours(edge.b);
  std::vector<Index> common;
  std::ranges::set_intersection(of_a, of_b, std::back_inserter(common));
  std::ranges::sort(common, {}, [&](Index c) { return cosine_over(points_[edge.a], points_[edge.b], points_[c]); });
  Sides result = {kNoIndex, kNoIndex};
  for (const Index c : common) {
    const int turn = orientation(points_[edge.a], points_[edge.b], points_[c]);
    if (turn == 0) continue;
    Index& corner = result[turn > 0 ? 0 : 1];
    if (corner == kNoIndex && is_empty({edge.a, edge.b, c})) corner = c;
  }
  return result;
}

}  // namespace mwt
