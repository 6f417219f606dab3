#include "algorithms/exact/holes/consistent_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "algorithms/triangle_lp/empty_triangles.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

using stage_testing::instances_of_all_families;

std::vector<Edge> hull_boundary(Points points) {
  const std::vector<Index> hull = convex_hull(points);
  std::vector<Edge> boundary;
  for (std::size_t i = 0; i < hull.size(); ++i) boundary.push_back({hull[i], hull[(i + 1) % hull.size()]});
  return boundary;
}

// Whether side i of `triangle` is locally minimal against a triangle of the list on its other side.
bool has_support(Points points, const Triangle& triangle, int i, const std::vector<Triangle>& triangles) {
  const Edge side = directed_edge(triangle, i);
  const Index apex = triangle[static_cast<std::size_t>(i)];
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& other) {
    for (int k = 0; k < 3; ++k) {
      if (directed_edge(other, k) != Edge{side.b, side.a}) continue;
      const Index across = other[static_cast<std::size_t>(k)];
      const bool is_convex = is_strictly_convex(points[side.a], points[across], points[side.b], points[apex]);
      return !is_convex || compare_length(points[side.a], points[side.b], points[apex], points[across]) <= 0;
    }
    return false;
  });
}

bool is_supported(Points points, const Triangle& triangle, const std::vector<Triangle>& triangles,
                  const std::vector<Edge>& boundary) {
  for (int i = 0; i < 3; ++i) {
    const bool is_boundary = std::find(boundary.begin(), boundary.end(), directed_edge(triangle, i)) != boundary.end();
    if (!is_boundary && !has_support(points, triangle, i, triangles)) return false;
  }
  return true;
}

// The definition: drop what is not supported until all is.
std::vector<Triangle> consistent_by_definition(Points points, std::vector<Triangle> triangles,
                                               const std::vector<Edge>& boundary) {
  for (bool changed = true; changed;) {
    std::vector<Triangle> kept;
    for (const Triangle& triangle : triangles) {
      if (is_supported(points, triangle, triangles, boundary)) kept.push_back(triangle);
    }
    changed = kept.size() < triangles.size();
    triangles = std::move(kept);
  }
  return triangles;
}

TEST(ConsistentTriangles, AreThoseOfTheDefinition) {
  for (const auto& [name, points] : instances_of_all_families({4, 6, 9, 12})) {
    SCOPED_TRACE(name);
    const std::vector<Triangle> given = empty_triangles(points);
    const std::vector<Edge> boundary = hull_boundary(points);
    EXPECT_EQ(consistent_triangles(points, given, boundary), consistent_by_definition(points, given, boundary));
  }
}

TEST(ConsistentTriangles, ContainTheOptimum) {
  for (const auto& [name, points] : instances_of_all_families({4, 6, 8, 9, 10}, 5)) {
    SCOPED_TRACE(name);
    std::vector<Triangle> kept = consistent_triangles(points, empty_triangles(points), hull_boundary(points));
    std::sort(kept.begin(), kept.end());
    const Solution optimum = solve_to_optimality("brute_force", points);
    for (const Triangle& triangle : canonical_triangles(optimum.triangulation)) {
      EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), triangle));
    }
  }
}

TEST(ConsistentTriangles, DropMostOnRandomPoints) {
  const std::vector<Point> points = generate("uniform", 30, 1);
  const std::vector<Triangle> given = empty_triangles(points);
  const auto kept = consistent_triangles(points, given, hull_boundary(points));
  EXPECT_LT(kept.size(), given.size() / 4);
  EXPECT_GE(kept.size(), 2 * points.size() - 2 - convex_hull(points).size());
}

TEST(ConsistentTriangles, DropWhatHasNoNeighbourAcrossASide) {
  const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const std::vector<Triangle> without_partner{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}};
  const std::vector<Triangle> rest{{0, 1, 3}, {1, 2, 3}};
  EXPECT_EQ(consistent_triangles(square, without_partner, hull_boundary(square)), rest);
}

TEST(ConsistentTriangles, DropTheLongerDiagonalAndKeepBothOfATie) {
  const std::vector<Triangle> all{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};
  const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_EQ(consistent_triangles(square, all, hull_boundary(square)), all);
  const std::vector<Point> leaning{{0, 0}, {2, 0}, {3, 2}, {1, 2}};
  const std::vector<Triangle> shorter{{0, 1, 3}, {1, 2, 3}};
  EXPECT_EQ(consistent_triangles(leaning, all, hull_boundary(leaning)), shorter);
}

TEST(ConsistentTriangles, MayBeNone) {
  const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_TRUE(consistent_triangles(square, {}, hull_boundary(square)).empty());
  const std::vector<Triangle> halves{{0, 1, 2}, {1, 2, 3}};
  EXPECT_TRUE(consistent_triangles(square, halves, hull_boundary(square)).empty());
}

}  // namespace
}  // namespace mwt
