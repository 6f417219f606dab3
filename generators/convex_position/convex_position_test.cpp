#include "generators/convex_position/convex_position.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(ConvexPosition, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("convex_position", 100, 1), "f3995738cb4252f4fd40315e774f5338");
  EXPECT_EQ(golden_hash("convex_position", 100, 2), "67628e7d9549cb4e1e1ee69aad4a1df4");
}

TEST(ConvexPosition, points_are_in_strictly_convex_position) {
  for (const Index n : {3U, 10U, 1000U, 100'000U}) {
    EXPECT_TRUE(is_in_strictly_convex_position(convex_position_points(n, 1))) << n;
  }
}

TEST(ConvexPositionSlow, points_are_in_strictly_convex_position_at_the_largest_n) {
  EXPECT_TRUE(is_in_strictly_convex_position(convex_position_points(kMaxConvexPosition, 1)));
}

}  // namespace
}  // namespace mwt
