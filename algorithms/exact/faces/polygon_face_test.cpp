#include "algorithms/exact/faces/polygon_face.h"

#include <gtest/gtest.h>

#include "algorithms/exact/testing/naive_candidates.h"
#include "algorithms/polygon_dp/polygon_dp.h"
#include "generators/registry.h"

namespace mwt {
namespace {

struct Solved {
  PolygonFaceOutcome outcome;
  FaceTriangles found;
};

// The face of the certain edges to the left of a -> b.
Solved solve_face(const CandidateGraph& graph, const Edge& start, const Deadline& deadline = {}) {
  const FaceWalker walker(graph);
  const auto corners = walker.corners_of_face(start);
  Solved solved;
  solved.outcome = PolygonFaceSolver(graph).solve(corners, deadline, solved.found);
  return solved;
}

// In convex position with all diagonals, as the other interval program computes it. Ties are common on lattices.
TEST(PolygonFace, IsOptimalInConvexPosition) {
  for (const Index n : {4U, 5U, 9U, 40U}) {
    for (const char* family : {"circle", "ellipse", "integer_circle", "parabola"}) {
      SCOPED_TRACE(std::string(family) + ' ' + std::to_string(n));
      const std::vector<Point> points = generate(family, n, 1);
      const std::vector<Index> hull = convex_hull(points);
      const CandidateGraph graph = naive::graph_with_certain(points, {});
      const Solved solved = solve_face(graph, {hull[0], hull[1]});
      ASSERT_EQ(solved.outcome, PolygonFaceOutcome::solved);
      EXPECT_EQ(solved.found.triangles.size(), n - 2);
      LengthSum weight = solved.found.diagonals;
      for (std::size_t i = 0; i < hull.size(); ++i) weight.add(points[hull[i]], points[hull[(i + 1) % hull.size()]]);
      EXPECT_TRUE(overlap(weight.enclosure(), triangulate_polygon(points, hull, PolygonObjective::edges).cost));
    }
  }
}

TEST(PolygonFace, TakesTheShorterDiagonalOfAQuadrilateral) {
  const std::vector<Point> points{{0, 0}, {4, 0}, {5, 3}, {0, 3}};
  const Solved solved = solve_face(naive::graph_with_certain(points, {}), {0, 1});
  ASSERT_EQ(solved.outcome, PolygonFaceOutcome::solved);
  EXPECT_TRUE(solved.found.diagonals.enclosure().contains(5));
  EXPECT_EQ(solved.found.triangles.size(), 2U);
}

TEST(PolygonFace, ReportsHolesAndMissingTriangulations) {
  const std::vector<Point> with_hole{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}};
  EXPECT_EQ(solve_face(naive::graph_with_certain(with_hole, {}), {0, 1}).outcome, PolygonFaceOutcome::not_a_polygon);
  const std::vector<Point> pentagon = generate("circle", 5, 1);
  const std::set<Edge> sides = naive::hull_edges(pentagon);
  std::vector<Edge> edges(sides.begin(), sides.end());
  const std::vector<Index> hull = convex_hull(pentagon);
  edges.push_back(make_edge(hull[0], hull[2]));
  const CandidateGraph graph = naive::make_graph(pentagon, edges, sides);
  EXPECT_EQ(solve_face(graph, {hull[0], hull[1]}).outcome, PolygonFaceOutcome::no_triangulation);
}

TEST(PolygonFace, StopsLargeFacesAtTheDeadline) {
  const Deadline late = std::chrono::steady_clock::now() - std::chrono::seconds(1);
  for (const Index n : {20U, 40U}) {
    const std::vector<Point> points = generate("circle", n, 1);
    const std::vector<Index> hull = convex_hull(points);
    const Solved solved = solve_face(naive::graph_with_certain(points, {}), {hull[0], hull[1]}, late);
    EXPECT_EQ(solved.outcome, n == 20 ? PolygonFaceOutcome::solved : PolygonFaceOutcome::out_of_time);
    EXPECT_EQ(solved.found.triangles.empty(), n == 40);
  }
}

}  // namespace
}  // namespace mwt
