#include "algorithms/exact/faces/region_solver.h"

#include <gtest/gtest.h>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "algorithms/exact/testing/stage_testing.h"

namespace mwt {
namespace {

using stage_testing::instances_of_all_families;

// Without the hull's edges, as the solver counts.
Interval optimum_of_diagonals(Points points, const Interval& optimum) {
  LengthSum hull;
  for (const Edge& edge : naive::hull_edges(points)) hull.add(points[edge.a], points[edge.b]);
  const Interval length = hull.enclosure();
  return {next_down(optimum.lower - length.upper), next_up(optimum.upper - length.lower)};
}

void expect_optimal(Points points, const RegionSolution& solution, const Interval& optimum) {
  const auto violation = find_violation(points, {static_cast<Index>(points.size()), solution.triangles});
  EXPECT_FALSE(violation) << violation->message;
  EXPECT_TRUE(solution.solved);
  const Interval expected = optimum_of_diagonals(points, optimum);
  const double margin = 1e-12 * optimum.upper;
  EXPECT_LE(solution.lower_bound, expected.upper);
  EXPECT_GE(solution.lower_bound, expected.lower - margin);
  EXPECT_LE(solution.diagonals.enclosure().lower, expected.upper + margin);
}

TEST(RegionSolver, EqualsTheSweptOptimumOfWholeInstances) {
  for (const auto& [name, points] : instances_of_all_families({4, 6, 8, 11}, 2)) {
    SCOPED_TRACE(name);
    const RegionSolution solution = solve_region(points, naive::region_of_hull(points), {});
    expect_optimal(points, solution, naive::SweptOptimum(points).weight());
  }
}

// Nothing but the hull is given here: most of these divide several times.
TEST(RegionSolver, EqualsTheTriangleProgramWithManyIsolatedVertices) {
  for (const auto& [name, points] : instances_of_all_families({26})) {
    SCOPED_TRACE(name);
    const Solution optimum = solve_and_check("triangle_lp", points);
    if (optimum.optimum->relative_width() > 1e-12) continue;
    expect_optimal(points, solve_region(points, naive::region_of_hull(points), {}), *optimum.optimum);
  }
}

TEST(RegionSolver, LeavesAValidTriangulationAndABoundWhenTheDeadlineHasPassed) {
  for (const auto& [name, points] : instances_of_all_families({12})) {
    SCOPED_TRACE(name);
    const Interval optimum = naive::SweptOptimum(points).weight();
    const FaceRegion region = naive::region_of_hull(points);
    const RegionSolution solution = solve_region(points, region, std::chrono::steady_clock::time_point::min());
    const auto violation = find_violation(points, {static_cast<Index>(points.size()), solution.triangles});
    EXPECT_FALSE(violation) << violation->message;
    EXPECT_LE(solution.lower_bound, optimum_of_diagonals(points, optimum).upper);
  }
}

}  // namespace
}  // namespace mwt
