#include "algorithms/exact/holes/certain_sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/holes/consistent_triangles.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "algorithms/triangle_lp/empty_triangles.h"

namespace mwt {
namespace {

using stage_testing::instances_of_all_families;

std::set<Edge> certain_edges(const CandidateGraph& graph) {
  std::set<Edge> edges;
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + 1]; ++h) {
      if (graph.certain[h] != 0) edges.insert(make_edge(v, graph.target[h]));
    }
  }
  return edges;
}

TEST(CertainSides, OfAllEmptyTrianglesAreTheUncrossedEdges) {
  for (const auto& [name, points] : instances_of_all_families({4, 6, 9, 13})) {
    SCOPED_TRACE(name);
    const FaceRegion region = naive::region_of_hull(points);
    const CandidateGraph graph = graph_of_sides(points, empty_triangles(points), region.boundary);
    EXPECT_EQ(certain_edges(graph), naive::uncrossed_edges(points, naive::possible_edges(points)));
  }
}

TEST(CertainSides, OfConsistentTrianglesAreInTheOptimum) {
  std::size_t dividing = 0;
  for (const auto& [name, points] : instances_of_all_families({5, 7, 10}, 3)) {
    SCOPED_TRACE(name);
    const FaceRegion region = naive::region_of_hull(points);
    const auto triangles = consistent_triangles(points, empty_triangles(points), region.boundary);
    const std::vector<Edge> optimum = edges_of(solve_to_optimality("brute_force", points).triangulation);
    const std::set<Edge> certain = certain_edges(graph_of_sides(points, triangles, region.boundary));
    EXPECT_TRUE(std::includes(optimum.begin(), optimum.end(), certain.begin(), certain.end()));
    dividing += certain.size() - naive::hull_edges(points).size();
  }
  EXPECT_GT(dividing, 100);
}

TEST(CertainSides, OneEndWithoutStraddlingTrianglesSuffices) {
  // Triangle 1-4-3 straddles edge 0-4 at 4 only; at 0 nothing does.
  const std::vector<Point> points{{0, 0}, {4, -3}, {8, 0}, {4, 3}, {5, 0}};
  const std::vector<Triangle> triangles{{0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {2, 3, 4}, {1, 4, 3}};
  const std::vector<Edge> boundary{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const std::set<Edge> certain = certain_edges(graph_of_sides(points, triangles, boundary));
  EXPECT_TRUE(certain.contains({0, 4}));
  EXPECT_FALSE(certain.contains({1, 3}));
}

}  // namespace
}  // namespace mwt
