#include "verifier/triangulation.h"

#include <algorithm>

#include "verifier/exact.h"
#include "verifier/refused.h"

namespace mwt::verifier {

namespace {

struct TriangleSide {
  Index from, to;
  friend auto operator<=>(const TriangleSide&, const TriangleSide&) = default;
};

// Ascending.
std::vector<TriangleSide> sides_of(const std::vector<Corners>& triangles) {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles) sides.insert(sides.end(), {{a, b}, {b, c}, {c, a}});
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

// Andrew's monotone chains, which keep collinear points.
std::vector<Index> hull_of(Points points) {
  std::vector<Index> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return points[a].x < points[b].x || (points[a].x == points[b].x && points[a].y < points[b].y);
  });
  const auto is_on_a_line = [&](Index p) { return turn(points[order.front()], points[order.back()], points[p]) == 0; };
  if (std::all_of(order.begin(), order.end(), is_on_a_line)) return {};
  std::vector<Index> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const Index p : order) {
      while (hull.size() >= first + 2 && turn(points[hull[hull.size() - 2]], points[hull.back()], points[p]) < 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();  // the other chain begins with it
    std::reverse(order.begin(), order.end());
  }
  return hull;
}

void check_triangulation(Points points, const std::vector<Index>& hull, const std::vector<Corners>& triangles) {
  require(triangles.size() == 2 * points.size() - 2 - hull.size(),
          "the triangulation has the wrong number of triangles");
  for (const Corners& t : triangles) {
    if (*std::max_element(t.begin(), t.end()) >= points.size())
      throw Refused("a triangle has a corner that is no point");
    if (turn(points[t[0]], points[t[1]], points[t[2]]) <= 0)
      throw Refused("a triangle does not turn left", {t[0], t[1], t[2]});
  }
  const std::vector<TriangleSide> sides = sides_of(triangles);
  const auto twice = std::adjacent_find(sides.begin(), sides.end());
  if (twice != sides.end()) {
    throw Refused("two triangles lie on the same side of an edge", {twice->from, twice->to});
  }
  std::vector<TriangleSide> boundary;
  for (const TriangleSide& side : sides) {
    if (!std::binary_search(sides.begin(), sides.end(), TriangleSide{side.to, side.from})) boundary.push_back(side);
  }
  std::vector<TriangleSide> expected;
  for (std::size_t i = 0; i < hull.size(); ++i) expected.push_back({hull[i], hull[(i + 1) % hull.size()]});
  std::sort(expected.begin(), expected.end());
  require(boundary == expected, "the boundary of the triangulation is not the convex hull");
}

// An inner edge is a side in both directions, one of the hull in the direction of the hull only.
Bounds weight_of(Points points, const std::vector<Corners>& triangles, const std::vector<Index>& hull) {
  Bounds sum = 0;
  const auto add_upward = [&](Index from, Index to) {
    if (from < to) sum += length(points[from], points[to]);
  };
  for (const auto& [a, b, c] : triangles) {
    add_upward(a, b);
    add_upward(b, c);
    add_upward(c, a);
  }
  for (std::size_t i = 0; i < hull.size(); ++i) add_upward(hull[(i + 1) % hull.size()], hull[i]);
  return sum;
}

}  // namespace mwt::verifier
