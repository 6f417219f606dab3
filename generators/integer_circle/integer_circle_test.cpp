#include "generators/integer_circle/integer_circle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <set>

#include "generators/testing.h"
#include "geometry/convex_hull.h"

namespace mwt {
namespace {

TEST(IntegerCircle, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("integer_circle", 100, 1), "70d9a6eecd46a5cff21a4f87012f2c32");
  EXPECT_EQ(golden_hash("integer_circle", 100, 2), "3069f0a63ddf87a62c3fbe5d5b2ad9ac");
}

TEST(IntegerCircle, points_are_integer_and_exactly_cocircular) {
  for (const Index n : {3U, 8U, 9U, 64U, 100U, 1000U, kMaxIntegerCircle}) {
    const std::vector<Point> points = integer_circle_points(n, 1);
    ASSERT_EQ(points.size(), n);
    std::set<std::int64_t> squared_radii;
    for (const Point& p : points) {
      EXPECT_TRUE(p.x == std::floor(p.x) && p.y == std::floor(p.y));
      const auto x = static_cast<std::int64_t>(p.x), y = static_cast<std::int64_t>(p.y);
      squared_radii.insert(x * x + y * y);
    }
    EXPECT_EQ(squared_radii.size(), 1U);
    EXPECT_EQ(make_point_set(points, "test").points.size(), n) << "distinct";
    EXPECT_EQ(convex_hull(points).size(), n);
  }
}

TEST(IntegerCircle, small_instances_lie_on_small_circles) {
  for (const Point& p : integer_circle_points(8, 1)) EXPECT_EQ(p.x * p.x + p.y * p.y, 5);
  for (const Point& p : integer_circle_points(9, 1)) EXPECT_EQ(p.x * p.x + p.y * p.y, 65);
}

}  // namespace
}  // namespace mwt
