#include "generators/wheel/wheel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/circle/circle.h"
#include "generators/testing.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

TEST(Wheel, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("wheel", 100, 1), "bb0b649fe084a33ae88242087a647e13");
  EXPECT_EQ(golden_hash("wheel", 100, 2), "c5bccf830e35e59771a198a1fe87e9fb");
}

TEST(Wheel, without_jitter_it_is_a_regular_polygon_and_its_centre) {
  std::vector<Point> expected = regular_polygon(13);
  expected.push_back({0, 0});
  EXPECT_EQ(wheel_points(14, 1, 0), expected);
}

TEST(Wheel, jitter_moves_points_by_at_most_half_its_size) {
  const std::vector<Point> exact = wheel_points(50, 1, 0), moved = wheel_points(50, 1, .01);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_LE(std::abs(moved[i].x - exact[i].x), .0051);
    EXPECT_LE(std::abs(moved[i].y - exact[i].y), .0051);
    EXPECT_NE(moved[i], exact[i]);
  }
}

TEST(Wheel, growing_spokes_are_strictly_increasing) {
  const std::vector<Point> points = wheel_points(1000, 1, 0, .01);
  const Point& centre = points.back();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    EXPECT_GT(compare_length(centre, points[i], centre, points[i - 1]), 0) << i;
  }
}

}  // namespace
}  // namespace mwt
