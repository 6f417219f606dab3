#include "algorithms/exact/faces/face_walk.h"

#include <gtest/gtest.h>

#include "algorithms/exact/testing/naive_candidates.h"

namespace mwt {
namespace {

// A square with three points inside.
const std::vector<Point> kPoints{{0, 0}, {20, 0}, {20, 20}, {0, 20}, {8, 7}, {12, 13}, {13, 6}};

// The vertices of all walks, each walk from the vertex behind its owner.
std::vector<std::vector<Index>> all_walks(const CandidateGraph& graph, std::size_t limit = 100) {
  const FaceWalker walker(graph);
  std::vector<std::vector<Index>> walks;
  std::vector<Corner> corners;
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + 1]; ++h) {
      const bool is_owner = graph.certain[h] != 0 && walker.walk(v, h, limit, corners) == WalkEnd::closed;
      if (!is_owner) continue;
      walks.emplace_back();
      for (const Corner& corner : corners) walks.back().push_back(corner.vertex);
    }
  }
  return walks;
}

using Walks = std::vector<std::vector<Index>>;

TEST(FaceWalk, KeepsFacesOnTheLeft) {
  const CandidateGraph graph = naive::graph_with_certain(kPoints, {{0, 2}});
  EXPECT_EQ(all_walks(graph), (Walks{{1, 2, 0}, {2, 3, 0}, {3, 2, 1, 0}}));
  EXPECT_EQ(all_walks(graph, 3), (Walks{{1, 2, 0}, {2, 3, 0}})) << "walks longer than the limit are left";
}

TEST(FaceWalk, GoesAlongBothSidesOfSlitsAndAroundInnerComponents) {
  const CandidateGraph graph = naive::graph_with_certain(kPoints, {{0, 4}, {5, 6}});
  EXPECT_EQ(all_walks(graph), (Walks{{1, 2, 3, 0, 4, 0}, {3, 2, 1, 0}, {6, 5}}));
}

TEST(FaceWalk, FindsTheOuterFace) {
  const CandidateGraph graph = naive::graph_with_certain(kPoints, {{0, 4}});
  const FaceWalker walker(graph);
  std::vector<Corner> corners;
  ASSERT_EQ(walker.walk(0, walker.owner_of_outer_face(), 100, corners), WalkEnd::closed);
  ASSERT_EQ(corners.size(), 4);
  EXPECT_EQ(corners[0].vertex, 3) << "clockwise around the hull";
  for (const Corner& corner : corners) EXPECT_EQ(corner.candidates, 0);
}

// Every halfedge that is not certain lies in one corner of one face, at both of its ends.
TEST(FaceWalk, CornersShareOutTheCandidates) {
  const CandidateGraph graph = naive::graph_with_certain(kPoints, {{0, 4}, {4, 5}, {4, 6}});
  const FaceWalker walker(graph);
  std::vector<int> found(graph.target.size(), 0);
  std::vector<Corner> corners;
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + 1]; ++h) {
      if (graph.certain[h] == 0 || walker.walk(v, h, 100, corners) != WalkEnd::closed) continue;
      for (const Corner& corner : corners) {
        for (std::uint32_t i = 0; i < corner.candidates; ++i) {
          const Index target = candidate_of(graph, corner, i);
          EXPECT_TRUE(leads_to(graph, corner, target));
          EXPECT_EQ(walker.corner_towards(corner.vertex, target).halfedge, corner.halfedge);
          const auto star = graph.star(corner.vertex);
          const auto place = std::find(star.begin(), star.end(), target) - star.begin();
          ++found[graph.first[corner.vertex] + static_cast<std::size_t>(place)];
        }
      }
    }
  }
  for (std::size_t h = 0; h < found.size(); ++h) EXPECT_EQ(found[h], graph.certain[h] == 0 ? 1 : 0);
}

TEST(FaceWalk, NamesBrokenGraphs) {
  CandidateGraph graph = naive::graph_with_certain(kPoints, {{0, 2}});
  graph.certain.assign(graph.certain.size(), 0);
  EXPECT_THROW((void)FaceWalker(graph).owner_of_outer_face(), std::logic_error);
}

}  // namespace
}  // namespace mwt
