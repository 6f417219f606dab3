#include "algorithms/greedy/queue/candidate.h"

#include <gtest/gtest.h>

#include <vector>

namespace mwt {

namespace {

// A square of side 2 with its centre: four spokes of one length, four longer sides.
TEST(CandidateQueue, TheFirstInGreedysOrderIsOnTop) {
  const std::vector<Point> points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  const PlanarMesh mesh = PlanarMesh::delaunay(points);
  const EdgeOrder order(mesh.points(), mesh.labels());
  CandidateQueue queue(order);
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) queue.push(Candidate::edge(mesh, order, e));
  std::vector<Edge> popped;
  for (; !queue.empty(); queue.pop()) popped.push_back(mesh.labelled_edge(edge_of(queue.top().place())));
  const std::vector<Edge> expected = {{0, 4}, {1, 4}, {2, 4}, {3, 4}, {0, 1}, {0, 3}, {1, 2}, {2, 3}};
  EXPECT_EQ(popped, expected);
}

TEST(Candidate, AnEarIsNamedByTheFirstHalfedgeOfItsWedge) {
  const std::vector<Point> points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  const PlanarMesh mesh = PlanarMesh::delaunay(points);
  const EdgeOrder order(mesh.points(), mesh.labels());
  for (Halfedge first = 0; first < 2 * mesh.edge_count(); ++first) {
    const Halfedge last = mesh.rotate_left(first);
    const Candidate ear = Candidate::ear(mesh, order, first, last), edge = Candidate::edge(mesh, order, edge_of(first));
    EXPECT_TRUE(ear.is_ear());
    EXPECT_FALSE(edge.is_ear());
    EXPECT_EQ(ear.place(), first);
    EXPECT_EQ(edge_of(edge.place()), edge_of(first));
    EXPECT_TRUE(ear.joins(mesh.target(last), mesh.target(first)));
    EXPECT_FALSE(ear.joins(mesh.origin(first), mesh.target(first)));
  }
}

}  // namespace

}  // namespace mwt
