#include "algorithms/greedy/bounds/certified_edges.h"

#include <gtest/gtest.h>

#include "geometry/predicates.h"
#include "geometry/testing/shapes.h"

namespace mwt {

namespace {

TEST(CertifiedEdges, CrossNoShorterSegment) {
  std::size_t certified = 0;
  for (const test::ShapeFamily& shape : test::shapes()) {
    const std::vector<Point> points = test::make_shape(shape, 25, 3);
    const PlanarMesh mesh = PlanarMesh::delaunay(points);
    for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
      if (mesh.is_hull(e) || !is_certainly_greedy(mesh, e)) continue;
      ++certified;
      const Edge edge = mesh.labelled_edge(e);
      for (Index p = 0; p < points.size(); ++p) {
        for (Index q = p + 1; q < points.size(); ++q) {
          if (!segments_cross(points[edge.a], points[edge.b], points[p], points[q]) || Edge{p, q} == edge) continue;
          EXPECT_LT(compare_length(points[edge.a], points[edge.b], points[p], points[q]), 0) << shape.name;
        }
      }
    }
  }
  EXPECT_GT(certified, 100U);
}

std::size_t certified_diagonals(const std::vector<Point>& quadrilateral) {
  const PlanarMesh mesh = PlanarMesh::delaunay(quadrilateral);
  std::size_t certified = 0;
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) certified += !mesh.is_hull(e) && is_certainly_greedy(mesh, e);
  return certified;
}

// A rhombus of two equilateral triangles is the limit: both opposite angles have 60 degrees.
TEST(CertifiedEdges, AngleSumsBelowHalfATurnDecide) {
  EXPECT_EQ(certified_diagonals({{0, 0}, {1, 0}, {.5, .9}, {.5, -.9}}), 1U);
  EXPECT_EQ(certified_diagonals({{0, 0}, {1, 0}, {.5, .8}, {.5, -.8}}), 0U);
}

// A rhombus of this size amid points at distance 1: is its short diagonal certified?
bool is_small_diagonal_certified(double size) {
  const std::vector<Point> points = {{0, 0},  {size, 0}, {.5 * size, .9 * size}, {.5 * size, -.9 * size}, {-1, -1},
                                     {1, -1}, {0, 1}};
  const PlanarMesh mesh = PlanarMesh::delaunay(points);
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.labelled_edge(e) == Edge{0, 1}) return is_certainly_greedy(mesh, e);
  }
  return false;
}

TEST(CertifiedEdges, AnglesBeyondTheTrustedRangeAreNotDecided) {
  EXPECT_TRUE(is_small_diagonal_certified(1e-40));
  EXPECT_FALSE(is_small_diagonal_certified(1e-50));
}

}  // namespace

}  // namespace mwt
