#include "algorithms/exact/candidates/convex_position.h"

#include <gtest/gtest.h>

#include <numeric>

#include "algorithms/exact/search_stopped.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "generators/registry.h"

namespace mwt {
namespace {

std::set<Edge> edges_of_graph(const CandidateGraph& graph) {
  std::set<Edge> edges;
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (const Index w : graph.star(v)) edges.insert(make_edge(v, w));
  }
  return edges;
}

// Also where points lie along the hull's sides: those are connected to their neighbours on the side only.
TEST(ConvexPosition, HasAllPossibleEdgesAndCertainSides) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  for (const std::vector<Point>& points : {generate("circle", 9, 1), generate("integer_circle", 12, 1), square}) {
    const CandidateGraph graph = convex_position_candidates(points, convex_hull(points));
    const std::vector<Edge> possible = naive::possible_edges(points);
    EXPECT_EQ(edges_of_graph(graph), std::set<Edge>(possible.begin(), possible.end()));
    const std::set<Edge> sides = naive::hull_edges(points);
    for (Index v = 0; v < points.size(); ++v) {
      for (std::uint32_t h = graph.first[v]; h < graph.first[v + 1]; ++h) {
        EXPECT_EQ(graph.certain[h] != 0, sides.contains(make_edge(v, graph.target[h])));
      }
    }
  }
}

TEST(ConvexPosition, StopsBeforeMemoryDoes) {
  const std::vector<Point> points = generate("circle", static_cast<Index>(kMaxConvexPolygon + 1), 1);
  std::vector<Index> hull(points.size());
  std::iota(hull.begin(), hull.end(), Index{0});
  EXPECT_THROW((void)convex_position_candidates(points, hull), SearchStopped);
}

}  // namespace
}  // namespace mwt
