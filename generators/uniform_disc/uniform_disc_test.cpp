#include "generators/uniform_disc/uniform_disc.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(UniformDisc, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("uniform_disc", 100, 1), "919df644e878df1bc5e652206e0e1d26");
  EXPECT_EQ(golden_hash("uniform_disc", 100, 2), "baaffc8c111fa80f8853de7862b8c04a");
}

TEST(UniformDisc, fills_the_disc_evenly) {
  constexpr Index kPoints = 10'000;
  int inner = 0, right = 0;
  for (const Point& p : uniform_disc_points(kPoints, 5)) {
    ASSERT_LE(p.x * p.x + p.y * p.y, 1);
    inner += p.x * p.x + p.y * p.y < .5 ? 1 : 0;
    right += p.x > 0 ? 1 : 0;
  }
  EXPECT_NEAR(inner, kPoints / 2., 5 * std::sqrt(kPoints / 4.));
  EXPECT_NEAR(right, kPoints / 2., 5 * std::sqrt(kPoints / 4.));
}

}  // namespace
}  // namespace mwt
