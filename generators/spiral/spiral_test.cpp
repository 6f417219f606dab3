#include "generators/spiral/spiral.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Spiral, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("spiral", 100, 1), "f5ba65654e5bd39f9599307f7ae206bf");
  EXPECT_EQ(golden_hash("spiral", 100, 1, {{"turns", "2"}}), "725f544543f23c7c40fb6bbcd2b4cca1");
}

TEST(Spiral, distance_grows_and_the_turns_are_counted) {
  const std::vector<Point> points = spiral_points(1000, 3);
  int crossings = 0;  // of the positive x axis
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_GT(compare_length({0, 0}, points[i], {0, 0}, points[i - 1]), 0);
    crossings += points[i - 1].y < 0 && points[i].y >= 0 && points[i].x > 0;
  }
  EXPECT_EQ(crossings, 2) << "between three turns";
}

TEST(Spiral, too_few_points_for_the_turns_are_refused) {
  EXPECT_NE(refusal("spiral", 40, {{"turns", "20"}}).find("nearest legal n is 41"), std::string::npos);
}

}  // namespace
}  // namespace mwt
