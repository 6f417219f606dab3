#include "algorithms/exact/bounds/side_bound.h"

#include <gtest/gtest.h>

#include "algorithms/exact/testing/hole_instances.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "generators/registry.h"

namespace mwt {
namespace {

double hull_length(Points points) {
  LengthSum hull;
  for (const Edge& edge : naive::hull_edges(points)) hull.add(points[edge.a], points[edge.b]);
  return hull.enclosure().lower;
}

TEST(SideBound, IsNoMoreThanTheOptimum) {
  for (const auto& [name, points] : stage_testing::instances_of_all_families({4, 7, 11}, 3)) {
    SCOPED_TRACE(name);
    const double optimum = naive::SweptOptimum(points).weight().upper - hull_length(points);
    EXPECT_LE(bound_by_sides(points, naive::region_of_hull(points)), optimum * (1 + 1e-14) + 1e-300);
  }
  for (const auto& [name, points] : hole_instances::instances(20, 8, 12, 1)) {
    SCOPED_TRACE(name);
    const double optimum = naive::SweptOptimum(points).weight().upper - hull_length(points);
    EXPECT_LE(bound_by_sides(points, naive::region_of_hull(points)), optimum * (1 + 1e-14));
  }
}

// One triangle, a fan and a square: nothing is lost.
TEST(SideBound, IsExactWhereTrianglesHaveNoChoice) {
  const std::vector<Point> triangle{{0, 0}, {4, 0}, {0, 3}};
  EXPECT_EQ(bound_by_sides(triangle, naive::region_of_hull(triangle)), 0);
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_NEAR(bound_by_sides(square, naive::region_of_hull(square)), std::sqrt(2), 1e-14);
  const std::vector<Point> star{{0, 0}, {4, 0}, {2, 3}, {2, 1}};
  const double spokes = 2 * std::sqrt(5) + 2;
  EXPECT_NEAR(bound_by_sides(star, naive::region_of_hull(star)), spokes, 1e-14);
}

}  // namespace
}  // namespace mwt
