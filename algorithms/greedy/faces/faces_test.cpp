#include "algorithms/greedy/faces/faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "algorithms/greedy/ears/ear_insertion.h"
#include "algorithms/greedy/faces/fixed_stars.h"
#include "algorithms/greedy/testing/greedy_testing.h"
#include "geometry/mesh/edge_order.h"

namespace mwt {

namespace {

struct Parts {
  explicit Parts(Points points, const std::vector<Edge>& constraints)
      : mesh(test::constrained_mesh(points, constraints)) {}

  [[nodiscard]] GreedyParts all() { return {mesh, order, stars, insertion, context}; }

  PlanarMesh mesh;
  EdgeOrder order{mesh.points(), mesh.labels()};
  FixedStars stars{mesh};
  EarInsertion insertion{mesh, stars};
  Context context;
};

// Two triangles of the hull with a point in each, divided by a fixed diagonal.
TEST(Faces, EndAtFixedEdges) {
  const std::vector<Point> points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {6, 3}, {4, 7}};
  Parts parts(points, {{0, 2}});
  Faces faces(parts.all(), 100);
  for (const MeshEdge e : test::inner_edges(parts.mesh)) {
    if (parts.mesh.labelled_edge(e).b != 4) continue;
    EXPECT_FALSE(faces.reduce_face(e));
    std::set<Edge> edges;
    for (const MeshEdge inside : faces.edges()) edges.insert(parts.mesh.labelled_edge(inside));
    EXPECT_EQ(edges, (std::set<Edge>{{0, 4}, {1, 4}, {2, 4}}));
    for (const MeshEdge inside : faces.edges()) parts.mesh.marks(inside) &= ~kFaceMark;
  }
}

std::size_t expect_greedy(Points points, const std::string& what) {
  const std::vector<Edge> greedy = test::greedy_edges(points);
  const std::vector<Edge> constraints = test::some_of(greedy, 4, 1);
  Parts parts(points, constraints);
  Faces faces(parts.all(), 0);
  std::size_t reduced = 0;
  for (const MeshEdge e : test::inner_edges(parts.mesh)) {
    while (!is_fixed_edge(parts.mesh, e) && faces.reduce_face(e)) ++reduced;
    for (const MeshEdge inside : faces.edges()) parts.mesh.marks(inside) &= ~kFaceMark;
  }
  const std::vector<Edge> fixed = test::fixed_edges(parts.mesh);
  EXPECT_TRUE(std::includes(greedy.begin(), greedy.end(), fixed.begin(), fixed.end())) << what;
  test::expect_constrained_delaunay(parts.mesh, what);
  return reduced;
}

// Every large face is reduced by one means or two, and only greedy edges are fixed.
TEST(Faces, LargeOnesAreReducedByGreedyEdges) { EXPECT_GT(test::sum_over_instances(4, 60, expect_greedy), 500U); }

}  // namespace

}  // namespace mwt
