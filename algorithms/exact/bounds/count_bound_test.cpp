#include "algorithms/exact/bounds/count_bound.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/bounds/simple_bound.h"
#include "algorithms/exact/testing/stage_testing.h"

namespace mwt {
namespace {

using stage_testing::instances_of_all_families;

void expect_counts_below_optima(const std::vector<stage_testing::NamedInstance>& instances) {
  for (const auto& [name, points] : instances) {
    SCOPED_TRACE(name);
    const double bound = bound_by_counts(points, {});
    EXPECT_GT(bound, 0);
    EXPECT_LE(bound, solve_to_optimality("subset_dp", points).optimum->upper);
  }
}

TEST(CountBound, IsNeverAboveTheOptimum) {
  expect_counts_below_optima(instances_of_all_families({3, 4, 5, 8, 12, 13}, 4));
}

TEST(CountBoundSlow, IsNeverAboveTheOptimum) {
  expect_counts_below_optima(instances_of_all_families({5, 6, 7, 9, 10, 11, 12, 13}, 20));
}

TEST(CountBound, IsNeverAboveTheOptimumOfLargerSets) {
  for (const auto& [name, points] : instances_of_all_families({60, 300}, 2)) {
    SCOPED_TRACE(name);
    EXPECT_LE(bound_by_counts(points, {}), solve_to_optimality("exact", points).optimum->upper);
  }
}

// Squares of such distances overflow or underflow.
TEST(CountBound, HoldsWhereSquaresAreOutOfRange) {
  for (const int exponent : {-1000, -600, -500, 400, 500, 600, 900}) {
    SCOPED_TRACE(exponent);
    std::vector<Point> points = generate("uniform", 40, 1);
    for (Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    EXPECT_LE(bound_by_counts(points, {}), solve_to_optimality("exact", points).optimum->upper);
    for (std::size_t i = 0; i < points.size(); i += 2) points[i] = {std::ldexp(points[i].x, -900), points[i].y};
    EXPECT_LE(bound_by_counts(points, {}), solve_to_optimality("exact", points).optimum->upper);
  }
}

TEST(CountBound, IsCloseOnRandomPoints) {
  for (const char* family : {"uniform", "normal", "clustered", "lattice"}) {
    SCOPED_TRACE(family);
    const std::vector<Point> points = generate(family, 3000, 1);
    EXPECT_GT(bound_by_counts(points, {}), 0.65 * solve_to_optimality("exact", points).optimum->lower);
  }
}

// A fan of long edges; a ring of short ones between triangles of very different sizes.
TEST(CountBound, IsTightWhereChainsFaceFarPoints) {
  for (const char* family : {"delaunay_flip_stuck", "insertion_trap"}) {
    SCOPED_TRACE(family);
    const std::vector<Point> points = generate(family, 600, 1);
    EXPECT_GT(bound_by_counts(points, {}), 0.999 * solve_to_optimality("exact", points).optimum->lower);
  }
}

// At least the simple bound, and never more than with time.
TEST(CountBound, HoldsAfterTheDeadline) {
  const std::vector<Point> points = generate("uniform", 500, 1);
  const double late = bound_by_counts(points, std::chrono::steady_clock::now());
  EXPECT_GE(late, simple_lower_bound(points) * (1 - 1e-12));
  EXPECT_LT(late, bound_by_counts(points, {}));
}

}  // namespace
}  // namespace mwt
