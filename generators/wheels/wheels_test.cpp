#include "generators/wheels/wheels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Wheels, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("wheels", 100, 1), "48c9e8d1a8757222114b563248ccca6d");
  EXPECT_EQ(golden_hash("wheels", 100, 2, {{"size", "20"}, {"jitter", "0.01"}}), "bfb85bd0f5c0355a5c1b7894a1b92741");
}

TEST(Wheels, every_wheel_has_its_rim_around_its_centre) {
  const std::vector<Point> points = wheels_points(142, 1, 14, 0);  // 9 wheels of 14, one of 16
  for (std::size_t wheel = 0; wheel < 10; ++wheel) {
    const std::size_t first = 14 * wheel, centre = wheel == 9 ? 141 : first + 13;
    for (std::size_t i = first; i < centre; ++i) {
      EXPECT_NEAR(std::hypot(points[i].x - points[centre].x, points[i].y - points[centre].y), 1, 1e-14);
    }
  }
  EXPECT_EQ(points[13], (Point{0, 0}));
  EXPECT_EQ(points[27], (Point{3, 0}));
  EXPECT_EQ(points[69], (Point{0, 3}));
}

TEST(Wheels, few_points_make_one_wheel) {
  EXPECT_TRUE(is_in_strictly_convex_position([] {
    std::vector<Point> rim = wheels_points(10, 1, 14, 0);
    rim.pop_back();
    return rim;
  }()));
}

}  // namespace
}  // namespace mwt
