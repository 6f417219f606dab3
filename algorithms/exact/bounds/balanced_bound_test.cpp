#include "algorithms/exact/bounds/balanced_bound.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/bounds/side_bound.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/weight.h"

namespace mwt {
namespace {

using stage_testing::instances_of_all_families;

// All pairs of points between the hull's sides.
FaceRegion whole_region(Points points) {
  FaceRegion region;
  for (Index v = 0; v < points.size(); ++v) region.vertices.push_back(v);
  const HullEdges hull = stage_testing::hull_of(points);
  for (Index v = 0; v < points.size(); ++v) {
    if (hull.next[v] != kNoIndex) region.boundary.push_back({v, hull.next[v]});
  }
  for (const Edge& edge : naive::possible_edges(points)) {
    if (!hull.contains(edge.a, edge.b)) region.candidates.push_back(edge);
  }
  return region;
}

Interval hull_length(Points points, const FaceRegion& region) {
  LengthSum sum;
  for (const Edge& edge : region.boundary) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure();
}

void expect_balanced_below_optima(const std::vector<stage_testing::NamedInstance>& instances) {
  double better = 0, count = 0;
  for (const auto& [name, points] : instances) {
    SCOPED_TRACE(name);
    const FaceRegion region = whole_region(points);
    const double bound = balanced_bound(points, region, {});
    const double optimum = solve_to_optimality("subset_dp", points).optimum->upper;
    EXPECT_LE(bound + hull_length(points, region).lower, optimum * (1 + 1e-15));
    better += bound > bound_by_sides(points, region) ? 1 : 0;
    ++count;
  }
  EXPECT_GT(better, count / 2);
}

TEST(BalancedBound, IsBelowTheOptimumAndMostlyAboveTheBoundBySides) {
  expect_balanced_below_optima(instances_of_all_families({5, 8, 11, 13}, 3));
}

TEST(BalancedBoundSlow, IsBelowTheOptimumAndMostlyAboveTheBoundBySides) {
  expect_balanced_below_optima(instances_of_all_families({6, 7, 9, 10, 12, 13}, 20));
}

TEST(BalancedBound, IsExactWhereATriangulationHasNoChoice) {
  // A square with its centre: the four spokes.
  const std::vector<Point> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  const FaceRegion region{{0, 1, 2, 3, 4}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {{0, 4}, {1, 4}, {2, 4}, {3, 4}}, 2};
  EXPECT_NEAR(balanced_bound(points, region, {}), 4 * std::sqrt(2), 1e-12);
  EXPECT_LE(balanced_bound(points, region, {}), 4 * std::sqrt(2));
}

TEST(BalancedBound, IsNothingAfterTheDeadline) {
  const std::vector<Point> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const FaceRegion region{{0, 1, 2, 3}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {{0, 2}, {1, 3}}, 1};
  EXPECT_GT(balanced_bound(points, region, {}), 2.8);
  EXPECT_EQ(balanced_bound(points, region, std::chrono::steady_clock::now()), 0);
}

}  // namespace
}  // namespace mwt
