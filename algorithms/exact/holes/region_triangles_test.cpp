#include "algorithms/exact/holes/region_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "algorithms/exact/testing/stage_testing.h"
#include "algorithms/triangle_lp/empty_triangles.h"

namespace mwt {
namespace {

using stage_testing::instances_of_all_families;

constexpr std::size_t kNoLimit = 1'000'000;

std::vector<Point> in_lexicographic_order(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), lexicographically_less);
  return points;
}

std::vector<Edge> all_sides(std::size_t points) {
  std::vector<Edge> sides;
  for (Index a = 0; a < points; ++a) {
    for (Index b = 0; b < points; ++b) {
      if (a != b) sides.push_back({a, b});
    }
  }
  return sides;
}

std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<Triangle> with_these_sides(std::vector<Triangle> triangles, const std::vector<Edge>& sides) {
  std::erase_if(triangles, [&](const Triangle& triangle) {
    for (int i = 0; i < 3; ++i) {
      if (std::find(sides.begin(), sides.end(), directed_edge(triangle, i)) == sides.end()) return true;
    }
    return false;
  });
  return triangles;
}

TEST(RegionTriangles, OfAllSidesAreTheEmptyTriangles) {
  for (const auto& [name, given] : instances_of_all_families({4, 7, 12, 25})) {
    SCOPED_TRACE(name);
    const std::vector<Point> points = in_lexicographic_order(given);
    const auto found = region_triangles(points, all_sides(points.size()), kNoLimit, {});
    ASSERT_TRUE(found);
    EXPECT_EQ(sorted(*found), empty_triangles(points));
  }
}

// One-way sides allow triangles on their left only, as a region's boundary does.
TEST(RegionTriangles, OfSomeSidesAreThoseThatHaveThem) {
  std::mt19937_64 random(7);
  for (const auto& [name, given] : instances_of_all_families({7, 12}, 2)) {
    SCOPED_TRACE(name);
    const std::vector<Point> points = in_lexicographic_order(given);
    std::vector<Edge> sides = all_sides(points.size());
    std::erase_if(sides, [&](const Edge&) { return random() % 3 == 0; });
    std::shuffle(sides.begin(), sides.end(), random);
    const auto found = region_triangles(points, sides, kNoLimit, {});
    ASSERT_TRUE(found);
    EXPECT_EQ(sorted(*found), with_these_sides(empty_triangles(points), sides));
  }
}

TEST(RegionTriangles, SidesThroughAPointHaveNone) {
  const std::vector<Point> points{{0, 0}, {0, 1}, {0, 2}, {1, 1}};
  const auto found = region_triangles(points, all_sides(4), kNoLimit, {});
  ASSERT_TRUE(found);
  EXPECT_EQ(sorted(*found), (std::vector<Triangle>{{0, 3, 1}, {1, 3, 2}}));
}

TEST(RegionTriangles, StopAtTheLimitAndAtTheDeadline) {
  const std::vector<Point> points = in_lexicographic_order(generate("uniform", 20, 1));
  const std::vector<Edge> sides = all_sides(points.size());
  const std::size_t count = region_triangles(points, sides, kNoLimit, {})->size();
  EXPECT_TRUE(region_triangles(points, sides, count, {}));
  EXPECT_FALSE(region_triangles(points, sides, count - 1, {}));
  EXPECT_FALSE(region_triangles(points, sides, kNoLimit, std::chrono::steady_clock::now()));
}

}  // namespace
}  // namespace mwt
