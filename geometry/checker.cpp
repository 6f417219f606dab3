#include "geometry/checker.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <unordered_set>

#include "geometry/convex_hull.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

using Result = std::optional<Violation>;

// A directed side and the position of its triangle, sorted by the side.
struct DirectedSide {
  std::uint64_t key;
  std::size_t triangle;
};

std::uint64_t key_of(Index from, Index to) { return (std::uint64_t{from} << 32) | to; }
Index from_of(std::uint64_t key) { return static_cast<Index>(key >> 32); }
Index to_of(std::uint64_t key) { return static_cast<Index>(key & 0xffffffffU); }
std::uint64_t reversed(std::uint64_t key) { return key_of(to_of(key), from_of(key)); }

template <class... Parts>
Violation violation(TriangulationRule rule, const Parts&... parts) {
  std::ostringstream message;
  message << name_of(rule) << ": ";
  (message << ... << parts);
  return {rule, message.str()};
}

std::string show(const Triangle& triangle) {
  std::ostringstream text;
  text << '(' << triangle[0] << ", " << triangle[1] << ", " << triangle[2] << ')';
  return text.str();
}

std::string show_side(std::uint64_t key) {
  std::ostringstream text;
  text << from_of(key) << " -> " << to_of(key);
  return text.str();
}

Result check_indices(Points points, const Triangulation& triangulation) {
  if (triangulation.point_count != points.size()) {
    return violation(TriangulationRule::point_count_matches, "triangulation of ", triangulation.point_count,
                     " points for an instance of ", points.size());
  }
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    for (const Index corner : triangulation.triangles[t]) {
      if (corner >= points.size()) {
        return violation(TriangulationRule::indices_in_range, "triangle ", t, ' ', show(triangulation.triangles[t]),
                         " has corner ", corner, ", but points go from 0 to ", points.size() - 1);
      }
    }
  }
  return {};
}

Result check_orientations(Points points, const Triangulation& triangulation) {
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    const auto [a, b, c] = triangulation.triangles[t];
    const int turn = orientation(points[a], points[b], points[c]);
    if (turn <= 0) {
      return violation(TriangulationRule::strictly_counter_clockwise, "triangle ", t, ' ',
                       show(triangulation.triangles[t]), turn == 0 ? " is flat" : " turns clockwise");
    }
  }
  return {};
}

std::vector<DirectedSide> sorted_sides(const Triangulation& triangulation) {
  std::vector<DirectedSide> sides;
  sides.reserve(3 * triangulation.triangles.size());
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    const auto [a, b, c] = triangulation.triangles[t];
    for (const std::uint64_t key : {key_of(a, b), key_of(b, c), key_of(c, a)}) sides.push_back({key, t});
  }
  std::sort(sides.begin(), sides.end(), [](const DirectedSide& a, const DirectedSide& b) { return a.key < b.key; });
  return sides;
}

Result check_doubled_sides(const std::vector<DirectedSide>& sides) {
  const auto doubled = std::adjacent_find(
      sides.begin(), sides.end(), [](const DirectedSide& a, const DirectedSide& b) { return a.key == b.key; });
  if (doubled == sides.end()) return {};
  return violation(TriangulationRule::directed_edge_once, "triangles ", doubled->triangle, " and ",
                   (doubled + 1)->triangle, " both lie left of edge ", show_side(doubled->key));
}

bool contains(const std::vector<DirectedSide>& sides, std::uint64_t key) {
  const auto place = std::lower_bound(sides.begin(), sides.end(), key,
                                      [](const DirectedSide& side, std::uint64_t k) { return side.key < k; });
  return place != sides.end() && place->key == key;
}

Result check_boundary(const std::vector<DirectedSide>& sides, const std::vector<Index>& hull) {
  std::unordered_set<std::uint64_t> hull_edges;
  for (std::size_t i = 0; i < hull.size(); ++i) hull_edges.insert(key_of(hull[i], hull[(i + 1) % hull.size()]));
  for (const DirectedSide& side : sides) {
    if (!contains(sides, reversed(side.key)) && !hull_edges.contains(side.key)) {
      return violation(TriangulationRule::boundary_is_hull, "nothing lies right of edge ", show_side(side.key),
                       " of triangle ", side.triangle, ", which is not on the hull");
    }
  }
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const std::uint64_t edge = key_of(hull[i], hull[(i + 1) % hull.size()]);
    if (!contains(sides, edge)) {
      return violation(TriangulationRule::hull_is_boundary, "hull edge ", show_side(edge), " belongs to no triangle");
    }
  }
  return {};
}

Result check_counts(const Triangulation& triangulation, std::size_t hull_size) {
  std::vector<bool> used(triangulation.point_count, false);
  for (const Triangle& triangle : triangulation.triangles) {
    for (const Index corner : triangle) used[corner] = true;
  }
  const std::size_t wanted = 2 * std::size_t{triangulation.point_count} - 2 - hull_size;
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end()) {
    return violation(TriangulationRule::every_point_used, "point ", unused - used.begin(), " is no corner; ",
                     triangulation.triangles.size(), " triangles, expected ", wanted);
  }
  if (triangulation.triangles.size() != wanted) {
    return violation(TriangulationRule::triangle_count, triangulation.triangles.size(), " triangles, expected ", wanted,
                     " = 2 * ", triangulation.point_count, " - 2 - ", hull_size);
  }
  return {};
}

}  // namespace

std::string_view name_of(TriangulationRule rule) {
  switch (rule) {
    case TriangulationRule::point_count_matches: return "point_count_matches";
    case TriangulationRule::indices_in_range: return "indices_in_range";
    case TriangulationRule::strictly_counter_clockwise: return "strictly_counter_clockwise";
    case TriangulationRule::directed_edge_once: return "directed_edge_once";
    case TriangulationRule::boundary_is_hull: return "boundary_is_hull";
    case TriangulationRule::hull_is_boundary: return "hull_is_boundary";
    case TriangulationRule::triangle_count: return "triangle_count";
    case TriangulationRule::every_point_used: return "every_point_used";
  }
  return "unknown rule";
}

std::optional<Violation> find_violation(Points points, const Triangulation& triangulation) {
  if (Result broken = check_indices(points, triangulation)) return broken;
  if (Result broken = check_orientations(points, triangulation)) return broken;
  const std::vector<DirectedSide> sides = sorted_sides(triangulation);
  if (Result broken = check_doubled_sides(sides)) return broken;
  const std::vector<Index> hull = convex_hull(points);
  if (Result broken = check_boundary(sides, hull)) return broken;
  return check_counts(triangulation, hull.size());
}

}  // namespace mwt
