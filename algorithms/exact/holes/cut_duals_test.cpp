#include "algorithms/exact/holes/cut_duals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/holes/region_reduction.h"
#include "algorithms/exact/testing/hole_instances.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "algorithms/exact/testing/stage_testing.h"

namespace mwt {
namespace {

// What is left holds the optimum, what is certain belongs to it, and bounds hold. A bound may cut off an optimum only
// if a triangulation of that length, up to rounding, is known.
void expect_reduction_keeps_optimum(Points points) {
  const FaceRegion region = naive::region_of_hull(points);
  if (region.components < 2) return;
  const auto reduced = reduce_region(points, region, std::numeric_limits<double>::infinity(), {});
  if (!reduced) return;
  const Triangulation optimum = solve_to_optimality("triangle_lp", points).triangulation;
  const Interval diagonals = diagonals_length(points, region, optimum.triangles).enclosure();
  EXPECT_LE(reduced->lower_bound, diagonals.upper);
  EXPECT_GE(reduced->diagonals.enclosure().upper, diagonals.lower);
  if (diagonals.upper * (1 + 1e-12) > reduced->reach) return;
  const std::vector<Edge> edges = edges_of(optimum);
  EXPECT_TRUE(std::includes(edges.begin(), edges.end(), reduced->certain.begin(), reduced->certain.end()));
  for (const Edge& edge : region.candidates) {
    const bool is_optimal = std::binary_search(edges.begin(), edges.end(), edge);
    EXPECT_LE(is_optimal, std::binary_search(reduced->candidates.begin(), reduced->candidates.end(), edge))
        << edge.a << ' ' << edge.b;
  }
}

TEST(CutDuals, KeepEveryOptimum) {
  for (const auto& [name, points] : hole_instances::instances(60, 10, 24, 11)) {
    SCOPED_TRACE(name);
    expect_reduction_keeps_optimum(points);
  }
  for (const auto& [name, points] : stage_testing::instances_of_all_families({20, 26}, 2)) {
    SCOPED_TRACE(name);
    expect_reduction_keeps_optimum(points);
  }
}

// Chords whose outside costs nothing were taken for forbidden ones: rounding had made a negative number of nothing.
TEST(CutDuals, KeepChordsThatCostNothing) { expect_reduction_keeps_optimum(generate("log_radial", 26, 1)); }

TEST(CutDuals, LeaveLittleOpenAmongIsolatedPoints) {
  const std::vector<Point> points = generate("uniform", 60, 1);
  const FaceRegion region = naive::region_of_hull(points);
  const auto reduced = reduce_region(points, region, std::numeric_limits<double>::infinity(), {});
  ASSERT_TRUE(reduced);
  EXPECT_LT(reduced->candidates.size(), region.candidates.size());
  EXPECT_GT(reduced->lower_bound, 0.9 * reduced->reach);
}

}  // namespace
}  // namespace mwt
