// Minimum weight triangulation of a convex polygon of any size, within the time and memory that there are.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/polygon_dp/polygon_dp.h"

namespace mwt {

struct ConvexPolygonSolution {
  std::vector<Triangle> triangles;        ///< n - 2, counter-clockwise, in the preorder of triangulate_polygon()
  Interval weight_of_optimum;             ///< certified, every edge once; its upper end is the weight of `triangles`
  std::optional<StopReason> stop_reason;  ///< why the optimum is not proved: deadline or memory
};

/// A triangulation of the convex polygon `polygon`, a counter-clockwise cycle of indices; vertices along sides allowed.
///
/// Of up to kSmallPolygon vertices that of triangulate_polygon(), in next to no time. Of more it is optimal to within
/// 1e-13 (ConvexProgram: n^3 / 6 sums, 4 n^2 bytes), unless the deadline or the memory of `context` does not allow
/// that. Then the lightest of what heuristics and coarser programs find, and a lower bound, within 1% on circles
/// (ConvexBounds: time and space linear in n). With a deadline the latter come first, so that more time never gives a
/// worse result.
///
/// `objective` decides ties of small polygons only, for the optimal triangulations are the same.
/// Precondition: at least 3 vertices, not all collinear. Uses context.threads, but no more than there are cores.
/// Deterministic, except for the deadline.
[[nodiscard]] ConvexPolygonSolution triangulate_convex_polygon(Points points, std::span<const Index> polygon,
                                                               PolygonObjective objective, Context& context);

inline constexpr std::size_t kSmallPolygon = 512;

}  // namespace mwt
