#include "generators/circle/circle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/testing.h"
#include "generators/unit_circle.h"
#include "geometry/convex_hull.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

TEST(Circle, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("circle", 100, 1), "451f514a9e7fa3c9ecf4fb3c3679594a");
}

bool is_strictly_convex_polygon(const std::vector<Point>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (orientation(points[i], points[(i + 1) % points.size()], points[(i + 2) % points.size()]) <= 0) return false;
  }
  return true;
}

TEST(Circle, points_lie_on_the_unit_circle_in_strictly_convex_position) {
  for (const Index n : {3U, 4U, 5U, 100U, 1023U, 65536U}) {
    const std::vector<Point> points = regular_polygon(n);
    EXPECT_TRUE(is_strictly_convex_polygon(points)) << n;
    EXPECT_EQ(convex_hull(points).size(), n);
    for (const Point& p : points) EXPECT_NEAR(p.x * p.x + p.y * p.y, 1, 4e-16);
  }
}

TEST(Circle, sides_are_equal_to_the_last_bits) {
  const std::vector<Point> points = regular_polygon(1000);
  const double side = 2 * std::sin(3.14159265358979324 / 1000);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR(std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y), side, 4e-16);
  }
}

// The bound in the header leaves a factor of ten here; neighbours at the steepest and at the flattest places.
TEST(Circle, is_strictly_convex_at_its_largest_n) {
  constexpr Index kN = kMaxRegularPolygon;
  for (const Index start : {0U, kN / 8, kN / 4 - 500, kN / 3, kN / 2}) {
    for (Index i = start; i < start + 1000; ++i) {
      EXPECT_GT(orientation(unit_circle_point(i, kN), unit_circle_point(i + 1, kN), unit_circle_point(i + 2, kN)), 0);
    }
  }
}

}  // namespace
}  // namespace mwt
