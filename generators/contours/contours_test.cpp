#include "generators/contours/contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Contours, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("contours", 100, 1), "4236f4eba90fa9f0157a433617294b10");
  EXPECT_EQ(golden_hash("contours", 200, 2, {{"levels", "3"}, {"summits", "2"}}), "824b15ad3c55996db15c757db08ea0c9");
}

TEST(Contours, points_lie_in_the_unit_square) {
  for (const Point& p : contours_points(2000, 1, 10, 8)) {
    EXPECT_TRUE(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1) << p.x << ' ' << p.y;
  }
}

// One bump: its level lines are circles around its top, cut off at the square's border, so that most points have a
// neighbour in the order of the points one step along the line.
TEST(Contours, neighbours_in_order_are_neighbours_on_a_line) {
  const std::vector<Point> points = contours_points(3000, 5, 4, 1);
  std::vector<double> steps;
  for (std::size_t i = 1; i < points.size(); ++i) {
    steps.push_back(std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y));
  }
  std::sort(steps.begin(), steps.end());
  EXPECT_LT(steps[2900], 2.5 * steps[1500]) << "all but a few jumps between lines are at most two steps";
  EXPECT_GT(steps[1500], 0);
}

}  // namespace
}  // namespace mwt
