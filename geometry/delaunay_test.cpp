#include "geometry/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "base/error.h"
#include "geometry/checker.h"
#include "geometry/predicates.h"
#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

bool has_edge(const Triangulation& triangulation, Index a, Index b) {
  return std::ranges::binary_search(edges_of(triangulation), make_edge(a, b));
}

// For every pair of neighbours: the far corner is not inside the circle through the triangle.
void expect_locally_delaunay(const std::vector<Point>& points, const Triangulation& triangulation) {
  const auto adjacent = adjacency_of(triangulation);
  for (std::size_t t = 0; t < adjacent.size(); ++t) {
    const auto [a, b, c] = triangulation.triangles[t];
    for (const Index neighbour : adjacent[t]) {
      if (neighbour == kNoIndex) continue;
      for (const Index corner : triangulation.triangles[neighbour]) {
        ASSERT_LE(in_circle(points[a], points[b], points[c], points[corner]), 0);
      }
    }
  }
}

TEST(Delaunay, IsAValidDelaunayTriangulationOfEveryShape) {
  for (const test::Shape& shape : test::all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Triangulation triangulation = delaunay_triangulation(shape.points);
    const auto violation = find_violation(shape.points, triangulation);
    ASSERT_FALSE(violation) << violation->message;
    expect_locally_delaunay(shape.points, triangulation);
    EXPECT_EQ(canonical_triangles(delaunay_triangulation(shape.points)), canonical_triangles(triangulation));
  }
}

TEST(Delaunay, CollinearPointsAreAnError) {
  EXPECT_THROW(static_cast<void>(delaunay_triangulation(std::vector<Point>{{0, 0}, {1, 1}, {2, 2}})), InputError);
  EXPECT_THROW(static_cast<void>(delaunay_triangulation({})), InputError);
}

TEST(ConstrainedDelaunay, ContainsItsConstraints) {
  const std::vector<Point> points{{0, 0}, {10, 0}, {10, 1}, {0, 1}, {5, 3}};
  const std::vector<Edge> constraints{{1, 3}, {0, 1}};
  const Triangulation triangulation = constrained_delaunay_triangulation(points, constraints);
  EXPECT_FALSE(find_violation(points, triangulation));
  EXPECT_TRUE(has_edge(triangulation, 1, 3));
}

// Keeping every edge of another triangulation gives that triangulation back.
TEST(ConstrainedDelaunay, RebuildsATriangulationFromItsEdges) {
  for (const test::Shape& shape : test::all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Triangulation triangulation = delaunay_triangulation(shape.points);
    const Triangulation rebuilt = constrained_delaunay_triangulation(shape.points, edges_of(triangulation));
    EXPECT_EQ(canonical_triangles(rebuilt), canonical_triangles(triangulation));
  }
}

TEST(ConstrainedDelaunay, WithoutConstraintsIsDelaunay) {
  const std::vector<Point> points = test::uniform_points(200, 5);
  EXPECT_EQ(canonical_triangles(constrained_delaunay_triangulation(points, {})),
            canonical_triangles(delaunay_triangulation(points)));
}

TEST(ConstrainedDelaunay, CrossingConstraintsAreALogicError) {
  const std::vector<Point> square = test::full_lattice(2, 2);
  const std::vector<Edge> diagonals{{0, 3}, {1, 2}};
  EXPECT_THROW(static_cast<void>(constrained_delaunay_triangulation(square, diagonals)), std::logic_error);
}

TEST(ConstrainedDelaunay, ConstraintsThroughPointsAreALogicError) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {2, 0}, {1, 1}, {1, -1}};
  const std::vector<Edge> through{{0, 2}};
  EXPECT_THROW(static_cast<void>(constrained_delaunay_triangulation(points, through)), std::logic_error);
}

TEST(DelaunayTime, TakesSomeTime) { EXPECT_GT(measure_delaunay_time_s(test::uniform_points(1000, 1)), 0); }

}  // namespace
}  // namespace mwt
