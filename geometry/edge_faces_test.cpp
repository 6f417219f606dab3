#include "geometry/edge_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "geometry/checker.h"
#include "geometry/delaunay.h"
#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

std::set<std::set<Index>> as_sets(const Triangulation& triangulation) {
  std::set<std::set<Index>> sets;
  for (const Triangle& t : triangulation.triangles) sets.insert({t[0], t[1], t[2]});
  return sets;
}

std::vector<Point> random_points(std::mt19937_64& random, bool on_lattice) {
  std::uniform_int_distribution<int> small(0, 6), large(0, 1'000'000);
  std::set<std::pair<int, int>> distinct;
  for (int i = 0; i < 25; ++i)
    distinct.insert(on_lattice ? std::pair(small(random), small(random)) : std::pair(large(random), large(random)));
  std::vector<Point> points;
  for (const auto& [x, y] : distinct) points.push_back({1.0 * x, 1.0 * y});
  return points;
}

TEST(EdgeFaces, AreTheTrianglesWhateverTheOrderOfTheEdges) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<Point> points = random_points(random, trial % 2 == 0);
    const Triangulation delaunay = delaunay_triangulation(points);
    std::vector<Edge> edges = edges_of(delaunay);
    edges.insert(edges.end(), edges.begin(), edges.begin() + 3);  // some twice
    for (Edge& e : edges) {
      if (random() % 2 == 0) std::swap(e.a, e.b);
    }
    std::shuffle(edges.begin(), edges.end(), random);
    const Triangulation result = triangulation_of(points, edges);
    EXPECT_EQ(as_sets(result), as_sets(delaunay));
    EXPECT_FALSE(find_violation(points, result));
  }
}

TEST(EdgeFaces, OfAMissingOrAForeignEdgeAreNoTriangulation) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<Point> points = random_points(random, trial % 2 == 0);
    std::vector<Edge> edges = edges_of(delaunay_triangulation(points));
    std::shuffle(edges.begin(), edges.end(), random);
    const std::vector<Edge> fewer(edges.begin() + 1, edges.end());
    EXPECT_TRUE(find_violation(points, triangulation_of(points, fewer)));
    const std::set<Edge> present(edges.begin(), edges.end());
    Edge foreign = make_edge(0, 1);
    while (present.contains(foreign)) {
      const auto a = static_cast<Index>(random() % points.size()), b = static_cast<Index>(random() % points.size());
      if (a != b) foreign = make_edge(a, b);
    }
    std::vector<Edge> swapped = fewer;
    swapped.push_back(foreign);
    const auto violation = find_violation(points, triangulation_of(points, swapped));
    // The two edges may be the diagonals of one quadrilateral.
    if (!violation) {
      EXPECT_EQ(edges_of(triangulation_of(points, swapped)).size(), edges.size());
    }
  }
}

TEST(EdgeFaces, HaveNoTriangleAroundAPoint) {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {0, 4}, {1, 1}};
  const std::vector<Edge> outline = {{0, 1}, {1, 2}, {0, 2}};
  EXPECT_EQ(triangulation_of(points, outline).triangles.size(), 1u);
  EXPECT_TRUE(find_violation(points, triangulation_of(points, outline))) << "it does not use all points";
  EXPECT_TRUE(triangulation_of(points, std::vector<Edge>{}).triangles.empty());
}

}  // namespace
}  // namespace mwt
