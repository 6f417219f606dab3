#include "algorithms/exact/holes/region_solver.h"

#include <gtest/gtest.h>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/holes/region_branching.h"
#include "algorithms/exact/testing/hole_instances.h"
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

struct NamedMethods {
  const char* name;
  RegionMethods methods;
};

// Each method with and without the others; the last is branching alone, down to polygons.
const std::vector<NamedMethods> kMethods = {{"all", {}},
                                            {"no annuli", {false, true, true}},
                                            {"reductions and branching", {false, true, false}},
                                            {"annuli and branching", {true, false, false}},
                                            {"programs", {false, false, true}},
                                            {"branching", {false, false, false}}};

void expect_optimal_by_all_methods(Points points, const Interval& optimum) {
  const FaceRegion region = naive::region_of_hull(points);
  if (region.components < 2) return;
  for (const auto& [name, methods] : kMethods) {
    SCOPED_TRACE(name);
    RegionSearch search;
    search.methods = methods;
    const RegionSolution solution = solve_region(points, region, search);
    expect_optimal(points, solution, optimum);
    if (!methods.annuli && !methods.reductions && !methods.programs) {
      EXPECT_GT(solution.counters.branchings, 0);
    }
  }
}

TEST(RegionSolver, EqualsTheSweptOptimumOfWholeInstances) {
  for (const auto& [name, points] : instances_of_all_families({4, 6, 8, 10}, 2)) {
    SCOPED_TRACE(name);
    expect_optimal_by_all_methods(points, naive::SweptOptimum(points).weight());
    if (HasFailure()) return;
  }
}

void compare_on_holes(std::size_t count, std::size_t smallest, std::size_t largest, std::uint64_t seed) {
  for (const auto& [name, points] : hole_instances::instances(count, smallest, largest, seed)) {
    SCOPED_TRACE(name);
    expect_optimal_by_all_methods(points, naive::SweptOptimum(points).weight());
    if (testing::Test::HasFailure()) return;
  }
}

TEST(RegionSolver, EqualsTheSweptOptimumWithHoles) { compare_on_holes(20, 8, 11, 1); }

TEST(RegionSolverSlow, EqualsTheSweptOptimumWithHolesOnThousandsOfInstances) { compare_on_holes(1000, 8, 13, 2); }

// Nothing but the hull is given here: most of these divide several times.
TEST(RegionSolver, EqualsTheTriangleProgramWithManyIsolatedVertices) {
  for (const auto& [name, points] : instances_of_all_families({26})) {
    SCOPED_TRACE(name);
    const Solution optimum = solve_and_check("triangle_lp", points);
    if (optimum.optimum->relative_width() > 1e-12) continue;
    expect_optimal(points, solve_region(points, naive::region_of_hull(points), {}), *optimum.optimum);
  }
}

// Middle-sized ones: the methods against each other.
void compare_methods(std::size_t count, std::size_t smallest, std::size_t largest, std::uint64_t seed) {
  for (const auto& [name, points] : hole_instances::instances(count, smallest, largest, seed)) {
    SCOPED_TRACE(name);
    const FaceRegion region = naive::region_of_hull(points);
    if (region.components < 2) continue;
    std::vector<double> weights;
    for (const auto& [method, methods] : std::span(kMethods).first(3)) {
      SCOPED_TRACE(method);
      RegionSearch search;
      search.methods = methods;
      const RegionSolution solution = solve_region(points, region, search);
      const auto violation = find_violation(points, {static_cast<Index>(points.size()), solution.triangles});
      EXPECT_FALSE(violation) << violation->message;
      EXPECT_TRUE(solution.solved);
      const double weight = solution.diagonals.enclosure().upper;
      EXPECT_LE(solution.lower_bound, weight);
      EXPECT_GE(solution.lower_bound, weight * (1 - 1e-12));
      weights.push_back(weight);
    }
    EXPECT_NEAR(weights[0], weights[1], 1e-12 * weights[0]);
    EXPECT_NEAR(weights[0], weights[2], 1e-12 * weights[0]);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(RegionSolver, MethodsAgreeOnHolesOfMiddleSize) { compare_methods(2, 24, 30, 3); }

TEST(RegionSolverSlow, MethodsAgreeOnHolesOfMiddleSize) { compare_methods(20, 30, 60, 4); }

TEST(RegionSolver, LeavesAValidTriangulationAndABoundWhenTheDeadlineHasPassed) {
  for (const auto& [name, points] : instances_of_all_families({12})) {
    SCOPED_TRACE(name);
    const Interval optimum = naive::SweptOptimum(points).weight();
    const FaceRegion region = naive::region_of_hull(points);
    const RegionSolution solution = solve_region(points, region, {std::chrono::steady_clock::time_point::min()});
    const auto violation = find_violation(points, {static_cast<Index>(points.size()), solution.triangles});
    EXPECT_FALSE(violation) << violation->message;
    EXPECT_LE(solution.lower_bound, optimum_of_diagonals(points, optimum).upper);
  }
}

TEST(RegionBranching, EveryTriangulationContainsAnUnavoidableCandidate) {
  for (const auto& [name, points] : hole_instances::instances(4, 10, 20, 5)) {
    SCOPED_TRACE(name);
    const FaceRegion region = naive::region_of_hull(points);
    if (region.components < 2) continue;
    const std::vector<Edge> unavoidable = unavoidable_candidates(points, region);
    for (const char* algorithm : {"delaunay", "sweep", "greedy"}) {
      const auto edges = edges_of(solve_and_check(algorithm, points).triangulation);
      EXPECT_TRUE(std::any_of(unavoidable.begin(), unavoidable.end(),
                              [&](const Edge& edge) { return std::binary_search(edges.begin(), edges.end(), edge); }));
    }
  }
}

TEST(RegionBranching, SaysWhenThereIsNoTriangulation) {
  const std::vector<Point> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {4, 3}};
  FaceRegion region = naive::region_of_hull(points);
  region.candidates = {{0, 4}, {1, 4}, {2, 4}};
  RegionSearch search;
  search.methods = {false, false, false};
  EXPECT_FALSE(solve_region(points, region, search).is_feasible());
}

}  // namespace
}  // namespace mwt
