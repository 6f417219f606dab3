#include "algorithms/exact/candidates/far_edges.h"

#include <gtest/gtest.h>

#include "algorithms/common/testing/solver_testing.h"
#include "generators/registry.h"

namespace mwt {
namespace {

// The hull's corners are a million times as far from the tiny polygon as its points are from each other. Edges from
// there along its rim would tie it to the ring around it.
TEST(FarEdges, ATinyPolygonFallsApartFromItsSurroundings) {
  const Solution solution = solve_to_optimality("exact", generate("insertion_trap", 64, 1));
  EXPECT_GT(solution.counters.at("far_edges_deleted"), 0);
  EXPECT_EQ(solution.counters.at("faces_with_holes"), 0);
}

TEST(FarEdges, ThereAreNoneAmongUniformPoints) {
  EXPECT_EQ(solve_to_optimality("exact", generate("uniform", 300, 1)).counters.at("far_edges_deleted"), 0);
}

// The nearest neighbours are too near for floats: they decide nothing, the others do.
TEST(FarEdges, OptimaOverMoreScalesThanFloatsHaveStayTheSame) {
  double deleted = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Point> points = generate("log_radial", 13, seed, {{"octaves", seed % 2 == 0 ? "160" : "300"}});
    const Solution solution = solve_to_optimality("exact", points);
    EXPECT_TRUE(overlap(*solution.optimum, *solve_to_optimality("subset_dp", points).optimum));
    deleted += solution.counters.at("far_edges_deleted");
  }
  EXPECT_GT(deleted, 0);
}

// Deleting too much would show as a heavier optimum.
TEST(FarEdges, OptimaOverManyScalesStayTheSame) {
  double deleted = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    for (const auto& points :
         {generate("log_radial", 25, seed, {{"octaves", "40"}}), generate("cluster_in_triangle", 25, seed),
          generate("clustered", 25, seed, {{"sigma", "0.00001"}})}) {
      const Solution solution = solve_to_optimality("exact", points);
      EXPECT_TRUE(overlap(*solution.optimum, *solve_to_optimality("triangle_lp", points).optimum));
      deleted += solution.counters.at("far_edges_deleted");
    }
  }
  EXPECT_GT(deleted, 0);
}

}  // namespace
}  // namespace mwt
