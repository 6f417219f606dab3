#include "generators/fan/fan.h"

#include <gtest/gtest.h>

#include "generators/testing.h"
#include "geometry/convex_hull.h"

namespace mwt {
namespace {

TEST(Fan, points_are_the_recorded_ones) { EXPECT_EQ(golden_hash("fan", 100, 1), "0e643d9805b5934d41d0aeaa3a466f33"); }

TEST(Fan, is_a_line_and_an_apex) {
  EXPECT_EQ(fan_points(3), (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(fan_points(6), (std::vector<Point>{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {3, 1}}));
  EXPECT_EQ(convex_hull(fan_points(100)).size(), 100U);
}

}  // namespace
}  // namespace mwt
