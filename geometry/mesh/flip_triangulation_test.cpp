#include "geometry/mesh/flip_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/checker.h"
#include "geometry/delaunay.h"

namespace mwt {
namespace {

std::vector<Point> random_points(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point> points(n);
  for (Point& p : points) p = {static_cast<double>(random() % 1000), static_cast<double>(random() % 1000)};
  return points;
}

TEST(FlipTriangulation, FlipsTheDiagonalOfASquare) {
  const std::vector<Point> points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  FlipTriangulation triangulation(Triangulation{4, {{0, 1, 2}, {0, 2, 3}}});
  ASSERT_EQ(triangulation.edge_count(), 5U);
  Index diagonal = 0;
  while (triangulation.is_boundary(diagonal)) ++diagonal;
  EXPECT_EQ(triangulation.edge(diagonal), (Edge{0, 2}));
  EXPECT_TRUE(is_flippable(points, triangulation, diagonal));
  triangulation.flip(diagonal);
  EXPECT_EQ(triangulation.edge(diagonal), (Edge{1, 3}));
  const std::vector<Triangle> expected = {{0, 1, 3}, {1, 2, 3}};
  EXPECT_EQ(canonical_triangles(triangulation.triangulation()), expected);
}

TEST(FlipTriangulation, AStraightOrReflexCornerForbidsTheFlip) {
  const Triangulation fan{4, {{0, 1, 3}, {1, 2, 3}}};
  const std::vector<Point> straight = {{0, 0}, {1, 0}, {2, 0}, {1, 2}};
  const std::vector<Point> reflex = {{0, 0}, {1, 1}, {2, 0}, {1, 3}};
  const FlipTriangulation triangulation(fan);
  for (Index e = 0; e < triangulation.edge_count(); ++e) {
    EXPECT_FALSE(is_flippable(straight, triangulation, e));
    EXPECT_FALSE(is_flippable(reflex, triangulation, e));
  }
}

TEST(FlipTriangulation, QuadrilateralAndSidesAgreeThroughManyFlips) {
  std::vector<Point> points = random_points(60, 3);
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  FlipTriangulation triangulation(delaunay_triangulation(points));
  std::mt19937_64 random(1);
  for (int step = 0; step < 2000; ++step) {
    const auto e = static_cast<Index>(random() % triangulation.edge_count());
    if (!is_flippable(points, triangulation, e)) continue;
    const auto [a, b, c, d] = triangulation.quadrilateral(e);
    const std::array<Index, 4> sides = triangulation.sides(e);
    EXPECT_EQ(triangulation.edge(e), make_edge(a, b));
    EXPECT_EQ(triangulation.edge(sides[0]), make_edge(b, c));
    EXPECT_EQ(triangulation.edge(sides[1]), make_edge(c, a));
    EXPECT_EQ(triangulation.edge(sides[2]), make_edge(a, d));
    EXPECT_EQ(triangulation.edge(sides[3]), make_edge(d, b));
    triangulation.flip(e);
    EXPECT_EQ(triangulation.edge(e), make_edge(c, d));
  }
  const auto violation = find_violation(points, triangulation.triangulation());
  EXPECT_FALSE(violation.has_value()) << violation->message;
}

TEST(FlipTriangulation, KeepsTheTriangulationItWasGiven) {
  std::vector<Point> points = random_points(40, 5);
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const Triangulation start = delaunay_triangulation(points);
  EXPECT_EQ(canonical_triangles(FlipTriangulation(start).triangulation()), canonical_triangles(start));
}

}  // namespace
}  // namespace mwt
