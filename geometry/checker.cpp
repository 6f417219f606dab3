#include "geometry/checker.h"

#include <fmt/core.h>

#include <algorithm>

#include "geometry/convex_hull.h"
#include "geometry/predicates.h"
#include "geometry/triangle_sides.h"

namespace mwt {

namespace {

using Result = std::optional<Violation>;

Violation violation(TriangulationRule rule, const std::string& what) {
  return {rule, fmt::format("{}: {}", name_of(rule), what)};
}

std::string show(const Triangle& triangle) {
  return fmt::format("({}, {}, {})", triangle[0], triangle[1], triangle[2]);
}

std::string show_side(Index from, Index to) { return fmt::format("{} -> {}", from, to); }

std::string show_side(Index smaller_end, const TriangleSide& side) {
  return side.is_ascending ? show_side(smaller_end, side.other_end) : show_side(side.other_end, smaller_end);
}

Result check_indices(Points points, const Triangulation& triangulation) {
  if (triangulation.point_count != points.size()) {
    return violation(
        TriangulationRule::point_count_matches,
        fmt::format("triangulation of {} points for an instance of {}", triangulation.point_count, points.size()));
  }
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    for (const Index corner : triangulation.triangles[t]) {
      if (corner >= points.size()) {
        return violation(TriangulationRule::indices_in_range,
                         fmt::format("triangle {} {} has corner {}, but points go from 0 to {}", t,
                                     show(triangulation.triangles[t]), corner, points.size() - 1));
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
      return violation(TriangulationRule::strictly_counter_clockwise,
                       fmt::format("triangle {} {}{}", t, show(triangulation.triangles[t]),
                                   turn == 0 ? " is flat" : " turns clockwise"));
    }
  }
  return {};
}

Result check_doubled_sides(Index point_count, const TriangleSides& sides) {
  for (Index v = 0; v < point_count; ++v) {
    const auto row = sides.row(v);
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      if (row[i].other_end == row[i + 1].other_end && row[i].is_ascending == row[i + 1].is_ascending) {
        return violation(TriangulationRule::directed_edge_once,
                         fmt::format("triangles {} and {} both lie left of edge {}", row[i].triangle,
                                     row[i + 1].triangle, show_side(v, row[i])));
      }
    }
  }
  return {};
}

// With every directed side at most once, a side is unpaired if neither neighbour in its row shares its other end.
bool is_unpaired(std::span<const TriangleSide> row, std::size_t i) {
  return (i == 0 || row[i - 1].other_end != row[i].other_end) &&
         (i + 1 == row.size() || row[i + 1].other_end != row[i].other_end);
}

bool has_side(const TriangleSides& sides, Index from, Index to) {
  const auto row = sides.row(std::min(from, to));
  return std::any_of(row.begin(), row.end(), [&](const TriangleSide& side) {
    return side.other_end == std::max(from, to) && side.is_ascending == (from < to);
  });
}

// For each point on the hull the next one counter-clockwise, kNoIndex for the others.
std::vector<Index> hull_successors(Index point_count, const std::vector<Index>& hull) {
  std::vector<Index> next(point_count, kNoIndex);
  for (std::size_t i = 0; i < hull.size(); ++i) next[hull[i]] = hull[(i + 1) % hull.size()];
  return next;
}

Result check_boundary(Index point_count, const TriangleSides& sides, const std::vector<Index>& hull) {
  const std::vector<Index> next = hull_successors(point_count, hull);
  for (Index v = 0; v < point_count; ++v) {
    const auto row = sides.row(v);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!is_unpaired(row, i)) continue;
      const bool on_hull = row[i].is_ascending ? next[v] == row[i].other_end : next[row[i].other_end] == v;
      if (!on_hull) {
        return violation(TriangulationRule::boundary_is_hull,
                         fmt::format("nothing lies right of edge {} of triangle {}, which is not on the hull",
                                     show_side(v, row[i]), row[i].triangle));
      }
    }
  }
  for (const Index v : hull) {
    if (!has_side(sides, v, next[v])) {
      return violation(TriangulationRule::hull_is_boundary,
                       fmt::format("hull edge {} belongs to no triangle", show_side(v, next[v])));
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
    return violation(TriangulationRule::every_point_used,
                     fmt::format("point {} is no corner; {} triangles, expected {}", unused - used.begin(),
                                 triangulation.triangles.size(), wanted));
  }
  if (triangulation.triangles.size() != wanted) {
    return violation(TriangulationRule::triangle_count,
                     fmt::format("{} triangles, expected {} = 2 * {} - 2 - {}", triangulation.triangles.size(), wanted,
                                 triangulation.point_count, hull_size));
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
  const TriangleSides sides(triangulation);
  if (Result broken = check_doubled_sides(triangulation.point_count, sides)) return broken;
  const std::vector<Index> hull = convex_hull(points);
  if (Result broken = check_boundary(triangulation.point_count, sides, hull)) return broken;
  return check_counts(triangulation, hull.size());
}

}  // namespace mwt
