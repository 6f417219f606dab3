#include "geometry/mesh/constraint_insertion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "geometry/checker.h"
#include "geometry/predicates.h"
#include "geometry/testing/shapes.h"

namespace mwt {

namespace {

using test::make_shape;
using test::ShapeFamily;
using test::shapes;

// Every third edge of a triangulation far from Delaunay.
std::vector<Edge> some_constraints(Points points, std::uint64_t seed) {
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  std::mt19937_64 random(seed);
  for (std::size_t i = 0; i < 20 * points.size(); ++i) {
    const auto e = static_cast<MeshEdge>(random() % mesh.edge_count());
    if (!mesh.is_hull(e) && mesh.is_flippable(e)) mesh.flip(e);
  }
  std::vector<Edge> constraints;
  for (MeshEdge e = 0; e < mesh.edge_count(); e += 3) constraints.push_back(mesh.labelled_edge(e));
  return constraints;
}

TEST(ConstraintInsertion, KeepsConstraintsAndIsDelaunayElsewhereOnAllShapes) {
  for (const ShapeFamily& shape : shapes()) {
    for (const std::size_t n : {4, 10, 50, 400}) {
      const std::vector<Point> points = make_shape(shape, n, n);
      std::vector<Edge> constraints = some_constraints(points, n);
      PlanarMesh mesh = PlanarMesh::delaunay(points);
      insert_constraints(mesh, constraints);
      const auto violation = find_violation(points, mesh.triangulation());
      ASSERT_FALSE(violation) << shape.name << " n=" << n << ": " << violation->message;
      std::sort(constraints.begin(), constraints.end());
      std::size_t kept = 0;
      for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
        if (std::binary_search(constraints.begin(), constraints.end(), mesh.labelled_edge(e))) {
          ++kept;
        } else if (!mesh.is_hull(e)) {
          const Halfedge h = 2 * e;
          ASSERT_LE(in_circle(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)), mesh.point(mesh.apex(h)),
                              mesh.point(mesh.apex(h + 1))),
                    0)
              << shape.name << " n=" << n;
        }
      }
      EXPECT_EQ(kept, constraints.size()) << shape.name << " n=" << n;
    }
  }
}

TEST(ConstraintInsertion, RefusesConstraintsThatCrossOrPassThroughPoints) {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}, {1, 2}, {2, 2}};
  const auto insert = [&](const std::vector<Edge>& edges) {
    PlanarMesh mesh = PlanarMesh::delaunay(points);
    insert_constraints(mesh, edges);
  };
  EXPECT_NO_THROW(insert({{4, 5}, {4, 6}}));
  EXPECT_THROW(insert({{4, 5}, {0, 6}}), std::logic_error);
  EXPECT_THROW(insert({{0, 2}}), std::logic_error) << "through the point (2, 2)";
}

}  // namespace

}  // namespace mwt
