#include "generators/flip_corridor/flip_corridor.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(FlipCorridor, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("flip_corridor", 100, 1), "e75f260ffc95438b31eaca3cba3f7e69");
}

TEST(FlipCorridor, both_chains_are_strictly_convex_up_to_the_largest_n) {
  for (const Index n : {6U, 7U, 100U, 4096U, kMaxFlipCorridor}) {
    const std::vector<Point> points = flip_corridor_points(n);
    ASSERT_EQ(points.size(), n);
    EXPECT_TRUE(turns_everywhere({points.begin(), points.end() - 3}, 1)) << n;
    EXPECT_TRUE(turns_everywhere({points.end() - 3, points.end()}, 1)) << n;
  }
}

// The fan that the sweep builds: from w_2 to every p_i, crossing nothing, though w_0 is nearer to all of them.
TEST(FlipCorridor, every_point_of_the_chain_sees_the_far_end) {
  const std::vector<Point> points = flip_corridor_points(100);
  const Point &w_0 = points[97], &w_1 = points[98], &w_2 = points[99];
  EXPECT_TRUE(lexicographically_less(w_2, w_1) && lexicographically_less(w_1, w_0));
  for (std::size_t i = 0; i < 96; ++i) {
    EXPECT_LT(compare_length(points[i], w_0, points[i], w_2), 0);
    for (std::size_t j = 0; j + 1 < 97; ++j) EXPECT_FALSE(segments_cross(points[i], w_2, points[j], points[j + 1]));
    EXPECT_FALSE(segments_cross(points[i], w_2, w_0, w_1));
  }
}

// Its quadrilaterals p_i p_{i+1} p_{i+2} w_2 are not convex: nothing to flip.
TEST(FlipCorridor, no_edge_of_the_fan_can_be_flipped) {
  const std::vector<Point> points = flip_corridor_points(1000);
  const Point& w_2 = points.back();
  for (std::size_t i = 0; i + 2 < 997; ++i) {
    EXPECT_FALSE(is_strictly_convex(points[i], points[i + 1], points[i + 2], w_2));
    EXPECT_FALSE(is_strictly_convex(points[i + 2], points[i + 1], points[i], w_2));
  }
}

}  // namespace
}  // namespace mwt
