#include "algorithms/triangle_lp/triangle_lp.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "algorithms/common/solve_scaled.h"
#include "algorithms/triangle_lp/empty_triangles.h"
#include "algorithms/triangle_lp/triangle_cover.h"
#include "geometry/convex_hull.h"
#include "geometry/delaunay.h"

namespace mwt {

namespace {

std::vector<Edge> hull_boundary(Points points) {
  const std::vector<Index> hull = convex_hull(points);
  std::vector<Edge> boundary;
  for (std::size_t i = 0; i < hull.size(); ++i) boundary.push_back({hull[i], hull[(i + 1) % hull.size()]});
  return boundary;
}

}  // namespace

Solution solve_triangle_program(Points points, Context& context) {
  const std::int64_t limit = context.parameters.integer("max_points");
  if (std::ssize(points) > limit) {
    throw NotApplicable(
        fmt::format("triangle_lp: {} points; it takes at most {} (parameter max_points)", points.size(), limit));
  }
  std::vector<Triangle> triangles;
  {
    const ScopedPhase phase(context, "empty_triangles");
    triangles = empty_triangles(points);
  }
  const ScopedPhase phase(context, "program");
  const std::vector<Edge> boundary = hull_boundary(points);
  const Triangulation start{static_cast<Index>(points.size()), canonical_triangles(delaunay_triangulation(points))};
  TriangleCover cover =
      lightest_triangle_cover({points, triangles, boundary, start.triangles.size(), context.deadline, start.triangles});
  Solution solution;
  solution.triangulation = {start.point_count, std::move(cover.triangles)};
  solution.optimum = cover.optimum;
  solution.stop_reason = cover.stop_reason;
  solution.counters = {{"empty_triangles", static_cast<double>(triangles.size())},
                       {"programs", static_cast<double>(cover.programs)},
                       {"branchings", static_cast<double>(cover.branchings)}};
  return solution;
}

AlgorithmInfo triangle_lp_entry() {
  AlgorithmInfo info;
  info.name = "triangle_lp";
  info.summary =
      "lightest cover of the hull by empty triangles: linear programming with branching, certified by dual bounds";
  info.source =
      "G. B. Dantzig, A. J. Hoffman, T. C. Hu, Triangulations (tilings) and certain block triangular matrices, "
      "Mathematical Programming 31, 1985";
  info.guarantee = "optimal, up to the certified interval it returns";
  info.time = "a few linear programs of O(n^2) rows; exponential in the worst case";
  info.space = "O(n^3), O(n^2) for uniform points";
  info.exactness = Exactness::exact;
  info.max_n = 150;
  info.version = 2;
  info.parameters = {{"max_points", ParameterType::integer, "400", "largest number of points it takes"}};
  info.function = [](Points points, Context& context) { return solve_scaled(points, context, solve_triangle_program); };
  return info;
}

}  // namespace mwt
