// The validity checker: no triangulation is used before it has passed here.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/triangulation.h"

namespace mwt {

/// The rules a triangulation can break. All are examined in this order, but the last two the other way round: an unused
/// point explains a wrong count.
enum class TriangulationRule {
  point_count_matches,         ///< the triangulation is of as many points as there are
  indices_in_range,            ///< every corner is a point
  strictly_counter_clockwise,  ///< every triangle turns left: none is flat, flipped or has a corner twice
  directed_edge_once,          ///< no directed edge belongs to two triangles: none is doubled, none overlaps there
  boundary_is_hull,            ///< a side without a neighbour is an edge of the hull: no hole, no notch
  hull_is_boundary,            ///< every edge of the hull, between neighbours on the boundary, is some triangle's side
  triangle_count,              ///< 2n - 2 - h triangles: none lies on top of others
  every_point_used,            ///< every point is a corner
};

[[nodiscard]] std::string_view name_of(TriangulationRule rule);

struct Violation {
  TriangulationRule rule;
  std::string message;  ///< one line: which rule, where (triangle position and point indices, from 0)
};

/// The first violation found, or nothing if `triangulation` is a triangulation of the convex hull of `points`.
///
/// Sufficient, not only necessary: sides cancel in pairs except for the hull's cycle, so the triangles, all positively
/// oriented, cover every place inside the hull exactly once and none outside; by the count they use every point.
///
/// Precondition: distinct points, not all collinear. The triangulation may be arbitrarily broken.
/// Exact predicates only. O(n log n) time, O(n) space.
[[nodiscard]] std::optional<Violation> find_violation(Points points, const Triangulation& triangulation);

}  // namespace mwt
