#include "generators/delaunay_arc/delaunay_arc.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(DelaunayArc, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("delaunay_arc", 100, 1), "9c327b9234c4549162ebf73824883db7");
  EXPECT_EQ(golden_hash("delaunay_arc", 100, 1, {{"coordinates", "integer"}}), "fef3bb29b211781e2d385fe46dfaf9a4");
  EXPECT_EQ(golden_hash("delaunay_arc", 101, 1, {{"coordinates", "integer"}}), "64eacb5ff693a4b2d01be685e706d7b3");
}

TEST(DelaunayArc, points_are_in_strictly_convex_position_up_to_the_largest_n) {
  for (const Index n : {4U, 5U, 6U, 100U, 1001U, kMaxArc}) {
    EXPECT_TRUE(is_in_strictly_convex_position(delaunay_arc_points(n))) << n;
  }
  for (const Index n : {4U, 5U, 6U, 100U, 1001U, kMaxIntegerArc}) {
    EXPECT_TRUE(is_in_strictly_convex_position(integer_delaunay_arc_points(n))) << n;
  }
}

// Of a convex curve's points, the nearest to the circle through two neighbours and b are the next ones.
void expect_fan_from_last(const std::vector<Point>& points) {
  const Point& b = points.back();
  const std::size_t arc = points.size() - 1;
  int orientation_of_arc = orientation(points[0], points[1], b);
  for (std::size_t i = 0; i + 2 < arc; ++i) {
    EXPECT_LT(orientation_of_arc * in_circle(points[i], points[i + 1], b, points[i + 2]), 0) << i;
    EXPECT_LT(orientation_of_arc * in_circle(points[i + 1], points[i + 2], b, points[i]), 0) << i;
  }
}

TEST(DelaunayArc, the_fan_is_delaunay) {
  for (const Index n : {5U, 6U, 64U, 1001U, 10000U}) {
    expect_fan_from_last(delaunay_arc_points(n));
    expect_fan_from_last(integer_delaunay_arc_points(n));
  }
}

TEST(DelaunayArcSlow, the_fan_is_delaunay_at_the_largest_n) {
  expect_fan_from_last(delaunay_arc_points(kMaxArc));
  expect_fan_from_last(integer_delaunay_arc_points(kMaxIntegerArc));
}

TEST(DelaunayArc, integers_are_exact_and_the_limit_is_told) {
  for (const Point& p : integer_delaunay_arc_points(kMaxIntegerArc)) {
    EXPECT_TRUE(p.x == std::floor(p.x) && p.y == std::floor(p.y) && p.x <= 0x1p53);
  }
  EXPECT_NE(refusal("delaunay_arc", 300'000, {{"coordinates", "integer"}}).find("nearest legal n is 262146"),
            std::string::npos);
}

}  // namespace
}  // namespace mwt
