#include "geometry/edge_faces.h"

#include <algorithm>
#include <vector>

#include "geometry/predicates.h"

namespace mwt {

namespace {

// The edges at every point, counter-clockwise by their direction.
class Stars {
 public:
  Stars(Points points, std::span<const Edge> edges) : points_(points), first_(points.size() + 1) {
    for (const auto& [a, b] : edges) {
      ++first_[a + 1];
      ++first_[b + 1];
    }
    for (std::size_t v = 0; v < points.size(); ++v) first_[v + 1] += first_[v];
    ends_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const auto& [a, b] : edges) {
      ends_[next[a]++] = b;
      ends_[next[b]++] = a;
    }
    for (Index v = 0; v < points.size(); ++v) sort_star(v);
  }

  [[nodiscard]] std::span<const Index> star(Index v) const {
    return {ends_.data() + first_[v], first_[v + 1] - first_[v]};
  }

  // The third corner of the face to the left of the edge from a to b, if it has three sides.
  [[nodiscard]] Index third_corner(Index a, Index b) const {
    const Index c = next_side(a, b);
    return c != a && next_side(b, c) == a && next_side(c, a) == b ? c : kNoIndex;
  }

 private:
  // Of directions in the upper half plane, that to the right included, or in the lower one.
  [[nodiscard]] bool points_down(Index from, Index to) const {
    const Point &p = points_[from], &q = points_[to];
    return q.y < p.y || (q.y == p.y && q.x < p.x);
  }

  // Counter-clockwise around v, beginning with the direction to the right.
  [[nodiscard]] bool comes_before(Index v, Index a, Index b) const {
    const bool a_down = points_down(v, a), b_down = points_down(v, b);
    if (a_down != b_down) return b_down;
    const int turn = orientation(points_[v], points_[a], points_[b]);
    return turn != 0 ? turn > 0 : a < b;
  }

  void sort_star(Index v) {
    std::sort(ends_.begin() + static_cast<std::ptrdiff_t>(first_[v]),
              ends_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]),
              [&](Index a, Index b) { return comes_before(v, a, b); });
  }

  // Where the face to the left of the edge from a to b goes on: the edge at b that is the next one clockwise from that
  // to a.
  [[nodiscard]] Index next_side(Index a, Index b) const {
    const std::span<const Index> ends = star(b);
    const auto place = std::lower_bound(ends.begin(), ends.end(), a,
                                        [&](Index one, Index other) { return comes_before(b, one, other); });
    return place == ends.begin() ? ends.back() : *(place - 1);
  }

  Points points_;
  std::vector<std::size_t> first_;
  std::vector<Index> ends_;
};

}  // namespace

Triangulation triangulation_of(Points points, std::span<const Edge> edges) {
  std::vector<Edge> distinct;
  for (const auto& [a, b] : edges) distinct.push_back(make_edge(a, b));
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  const Stars stars(points, distinct);
  Triangulation result{static_cast<Index>(points.size()), {}};
  // Every triangle is seen from its smallest corner.
  for (Index a = 0; a < points.size(); ++a) {
    for (const Index b : stars.star(a)) {
      const Index c = b > a ? stars.third_corner(a, b) : kNoIndex;
      if (c != kNoIndex && c > a && orientation(points[a], points[b], points[c]) > 0)
        result.triangles.push_back({a, b, c});
    }
  }
  return result;
}

}  // namespace mwt
