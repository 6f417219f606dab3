#include "algorithms/polygon_dp/convex_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/polygon_dp/preorder.h"
#include "algorithms/polygon_dp/testing/convex_polygons.h"
#include "geometry/checker.h"

namespace mwt {
namespace {

using convex_testing::cycle_of;
using convex_testing::polygons;

ConvexPolygonSolution solve(const std::vector<Point>& points, const std::vector<Index>& cycle, Context& context) {
  ConvexPolygonSolution solution = triangulate_convex_polygon(points, cycle, PolygonObjective::edges, context);
  const Triangulation triangulation{static_cast<Index>(points.size()), solution.triangles};
  EXPECT_FALSE(find_violation(points, triangulation));
  EXPECT_LE(solution.weight_of_optimum.lower, solution.weight_of_optimum.upper);
  EXPECT_GE(solution.weight_of_optimum.upper, weight(points, triangulation).lower);
  return solution;
}

TEST(Preorder, IsThatOfTheParts) {
  const std::vector<Triangle> triangles = {{2, 3, 4}, {4, 0, 2}, {1, 2, 0}};
  EXPECT_EQ(in_preorder(triangles, 5), (std::vector<Triangle>{{0, 2, 4}, {0, 1, 2}, {2, 3, 4}}));
}

TEST(ConvexPolygon, IsProvedFromAnyVertexOn) {
  for (const auto& [name, points] : polygons(600)) {
    SCOPED_TRACE(name);
    std::vector<Index> cycle = cycle_of(points);
    for (const int turn : {0, 123}) {
      std::rotate(cycle.begin(), cycle.begin() + turn, cycle.end());
      Context context;
      const ConvexPolygonSolution solution = solve(points, cycle, context);
      EXPECT_FALSE(solution.stop_reason);
      EXPECT_LE(solution.weight_of_optimum.relative_width(), 1e-12);
      EXPECT_EQ(solution.triangles.front()[0], cycle.front());
      EXPECT_EQ(solution.triangles.front()[2], cycle.back());
    }
  }
}

TEST(ConvexPolygon, IsBoundedWithoutMemory) {
  for (const auto& [name, points] : polygons(2000)) {
    SCOPED_TRACE(name);
    Context whole, little;
    const Interval optimum = solve(points, cycle_of(points), whole).weight_of_optimum;
    little.memory_bytes = std::uint64_t{15} << 20;  // the whole program needs 16
    const ConvexPolygonSolution solution = solve(points, cycle_of(points), little);
    EXPECT_EQ(solution.stop_reason, StopReason::memory);
    EXPECT_LE(solution.weight_of_optimum.lower, optimum.upper);
    EXPECT_GE(solution.weight_of_optimum.upper, optimum.lower);
  }
}

TEST(ConvexPolygon, IsTriangulatedPastTheDeadline) {
  const std::vector<Point> points = convex_testing::hull_cycle(generate("circle", 3000, 1));
  Context context;
  context.deadline = Context::Clock::now();
  EXPECT_EQ(solve(points, cycle_of(points), context).stop_reason, StopReason::deadline);
}

}  // namespace
}  // namespace mwt
