#include "algorithms/exact/faces/face_region.h"

#include <gtest/gtest.h>

#include <set>

#include "algorithms/exact/holes/region_solver.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "geometry/checker.h"

namespace mwt {
namespace {

// A rectangle with seven points inside, in two groups.
const std::vector<Point> kRectangleWithPoints{{0, 0},  {40, 0}, {40, 20}, {0, 20},  {8, 7}, {12, 13},
                                              {13, 6}, {28, 6}, {33, 8},  {29, 14}, {30, 9}};

struct Faces {
  std::vector<Walk> walks;
  std::vector<Index> isolated;
};

// All walks that do not belong to finished triangles or to the outer face.
Faces open_faces(const CandidateGraph& graph, const FaceWalker& walker) {
  Faces faces;
  const std::uint32_t outer = walker.owner_of_outer_face();
  for (Index v = 0; v < graph.points.size(); ++v) {
    bool is_isolated = true;
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + 1]; ++h) {
      if (graph.certain[h] == 0) continue;
      is_isolated = false;
      Walk walk;
      if (walker.walk(v, h, 1000, walk) != WalkEnd::closed || h == outer) continue;
      const bool is_open = std::any_of(walk.begin(), walk.end(), [](const Corner& c) { return c.candidates > 0; });
      if (is_open) faces.walks.push_back(walk);
    }
    if (is_isolated) faces.isolated.push_back(v);
  }
  return faces;
}

std::vector<FaceRegion> regions_of(const CandidateGraph& graph) {
  const FaceWalker walker(graph);
  const Faces faces = open_faces(graph, walker);
  return group_into_regions(graph, walker, faces.walks, faces.isolated);
}

TEST(FaceRegion, GroupsWhatLiesInOneFace) {
  // Edge 1-4 splits the rectangle in two; each half has a hole and an isolated vertex.
  const std::vector<Point> points{{0, 0},   {20, 0}, {40, 0}, {40, 20}, {20, 20}, {0, 20}, {8, 7},
                                  {12, 13}, {13, 6}, {28, 6}, {33, 8},  {29, 14}, {35, 15}};
  const CandidateGraph graph = naive::graph_with_certain(points, {{1, 4}, {6, 7}, {9, 10}, {10, 11}, {9, 11}});
  const std::vector<FaceRegion> regions = regions_of(graph);
  ASSERT_EQ(regions.size(), 2);
  EXPECT_EQ(regions[0].vertices, (std::vector<Index>{0, 1, 4, 5, 6, 7, 8}));
  EXPECT_EQ(regions[0].components, 3);
  EXPECT_EQ(regions[0].boundary.size(), 4 + 2);
  EXPECT_EQ(regions[0].triangle_count(), 2 * 7 - 2 - 4);
  EXPECT_EQ(regions[1].vertices, (std::vector<Index>{1, 2, 3, 4, 9, 10, 11, 12}));
  EXPECT_EQ(regions[1].components, 3);
  EXPECT_EQ(regions[1].boundary.size(), 4 + 3);
  EXPECT_EQ(regions[1].triangle_count(), 2 * 8 - 2 - 4 - 1) << "the hole is a triangle";
}

void expect_fills(const FaceRegion& region, const std::vector<Triangle>& triangles, std::vector<Triangle> others) {
  EXPECT_EQ(triangles.size(), region.triangle_count());
  others.insert(others.end(), triangles.begin(), triangles.end());
  const auto violation =
      find_violation(kRectangleWithPoints, {static_cast<Index>(kRectangleWithPoints.size()), others});
  EXPECT_FALSE(violation) << violation->message;
}

TEST(FaceRegion, FillsAndBoundsRegionsOfAllKinds) {
  struct Case {
    std::set<Edge> certain;
    std::vector<Triangle> finished;  // triangles outside the region
  };
  const std::vector<Case> cases = {
      {{}, {}},
      {{{4, 5}, {8, 9}}, {}},
      {{{4, 5}, {4, 6}, {5, 6}}, {{4, 6, 5}}},
      {{{0, 4}, {4, 5}, {4, 6}, {7, 8}}, {}},
      {{{7, 8}, {8, 9}, {7, 9}, {7, 10}, {8, 10}, {9, 10}, {2, 8}}, {{7, 8, 10}, {8, 9, 10}, {9, 7, 10}}}};
  const double optimum = naive::SweptOptimum(kRectangleWithPoints).weight().lower;
  for (const auto& [certain, finished] : cases) {
    const CandidateGraph graph = naive::graph_with_certain(kRectangleWithPoints, certain);
    const std::vector<FaceRegion> regions = regions_of(graph);
    ASSERT_EQ(regions.size(), 1);
    const FaceRegion& region = regions.front();
    const RegionSolution unsolved = leave_unsolved(kRectangleWithPoints, region, StopReason::size, {});
    expect_fills(region, unsolved.triangles, finished);
    EXPECT_FALSE(unsolved.solved);
    const RegionSolution solved = solve_region(kRectangleWithPoints, region, {});
    expect_fills(region, solved.triangles, finished);
    EXPECT_TRUE(solved.solved);
    EXPECT_LE(solved.diagonals.enclosure().lower, unsolved.diagonals.enclosure().upper);
    EXPECT_LE(unsolved.lower_bound, solved.lower_bound);
    EXPECT_LE(solved.lower_bound, solved.diagonals.enclosure().upper);
    EXPECT_GE(solved.lower_bound, (1 - 1e-12) * solved.diagonals.enclosure().lower);
    const Interval whole = weight(kRectangleWithPoints, [&] {
      Triangulation all{static_cast<Index>(kRectangleWithPoints.size()), solved.triangles};
      all.triangles.insert(all.triangles.end(), finished.begin(), finished.end());
      return all;
    }());
    EXPECT_GE(whole.upper, optimum);
    if (certain.empty()) {
      EXPECT_LE(whole.lower, optimum * (1 + 1e-12));
    }
  }
}

TEST(FaceRegion, DiagonalsAreCountedOnceAndBoundaryNever) {
  const CandidateGraph graph = naive::graph_with_certain(kRectangleWithPoints, {{4, 5}});
  const FaceRegion region = regions_of(graph).front();
  const std::vector<Triangle> triangles = fill_region(kRectangleWithPoints, region);
  const Triangulation whole{static_cast<Index>(kRectangleWithPoints.size()), triangles};
  LengthSum sum = diagonals_length(kRectangleWithPoints, region, triangles);
  for (const Edge& edge : {Edge{0, 1}, Edge{1, 2}, Edge{2, 3}, Edge{0, 3}, Edge{4, 5}}) {
    sum.add(kRectangleWithPoints[edge.a], kRectangleWithPoints[edge.b]);
  }
  EXPECT_TRUE(overlap(sum.enclosure(), weight(kRectangleWithPoints, whole)));
}

}  // namespace
}  // namespace mwt
