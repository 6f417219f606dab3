#include "generators/greedy_ratio/greedy_ratio.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(GreedyRatio, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("greedy_ratio", 100, 1), "5fab6b4b5459fefcc3e0cd97efb2ece7");
  EXPECT_EQ(golden_hash("greedy_ratio", 100, 1, {{"alpha", "1.5"}}), "a99b7a5f8ca810032ea66395117439e6");
}

std::vector<Point> left_chain(Index n, double alpha) {
  std::vector<Point> points = greedy_ratio_points(n, alpha);
  points.resize(n - 2);
  return points;
}

TEST(GreedyRatio, the_chain_is_strictly_convex_up_to_the_largest_n) {
  for (const double alpha : {1.001, 1.1, 1.3, 1.5}) {
    for (const Index n : {5U, 6U, 100U, 4096U, kMaxGreedyRatio}) {
      EXPECT_TRUE(turns_everywhere(left_chain(n, alpha), -1)) << alpha << ' ' << n;
    }
  }
}

// The trap: the edge from v to w_1 is shorter than all p_i w_0, which it crosses.
TEST(GreedyRatio, the_edge_that_shuts_the_corridor_is_the_shortest) {
  for (const double alpha : {1.001, 1.1, 1.3, 1.5}) {
    const std::vector<Point> points = greedy_ratio_points(200, alpha);
    const Point &v = points[197], &w_0 = points[198], &w_1 = points[199];
    for (Index i = 0; i < 197; ++i) {
      EXPECT_LT(compare_length(v, w_1, points[i], w_0), 0);
      EXPECT_TRUE(segments_cross(v, w_1, points[i], w_0));
    }
  }
}

TEST(GreedyRatio, distances_have_the_asked_quotient) {
  for (const double alpha : {1.1, 1.3, 1.5}) {
    const std::vector<Point> points = greedy_ratio_points(50, alpha);
    const auto distance_from_p_0 = [&](const Point& q) { return std::hypot(q.x - points[0].x, q.y - points[0].y); };
    EXPECT_NEAR(distance_from_p_0(points[49]) / distance_from_p_0(points[48]), alpha, .01);
  }
}

TEST(GreedyRatio, other_ratios_are_refused) {
  EXPECT_NE(refusal("greedy_ratio", 100, {{"alpha", "1"}}).find("alpha=1 is not between 1.001 and 1.5"),
            std::string::npos);
}

}  // namespace
}  // namespace mwt
