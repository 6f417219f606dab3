#include "algorithms/exact/candidates/candidate_graph.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

std::vector<Index> star_of(const CandidateGraph& graph, Index v) {
  return {graph.star(v).begin(), graph.star(v).end()};
}

TEST(CandidateGraph, HasStarsInCounterClockwiseOrderWithMarks) {
  const std::vector<Point> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {9, 9}};
  const std::vector<Edge> edges{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}};
  const std::vector<Edge> certain{{0, 1}, {0, 3}, {1, 2}, {2, 3}};
  const CandidateGraph graph = make_candidate_graph(points, edges, certain);
  EXPECT_EQ(star_of(graph, 0), (std::vector<Index>{1, 2, 3}));
  EXPECT_EQ(star_of(graph, 2), (std::vector<Index>{3, 0, 1}));
  EXPECT_TRUE(graph.star(4).empty());
  EXPECT_EQ(graph.first, (std::vector<std::uint32_t>{0, 3, 5, 8, 10, 10}));
  EXPECT_EQ(graph.certain, (std::vector<std::uint8_t>{1, 0, 1, 1, 1, 1, 0, 1, 1, 1}));
}

}  // namespace
}  // namespace mwt
