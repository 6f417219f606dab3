#include "generators/uniform/uniform.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Uniform, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("uniform", 100, 1), "45d0455610e2a93771ee270c69ecad53");
  EXPECT_EQ(golden_hash("uniform", 100, 2), "b868dbeb5b8e3addea514b149dd2665d");
}

TEST(Uniform, fills_the_unit_square_evenly) {
  constexpr Index kPoints = 10'000;
  std::array<int, 16> counts{};
  for (const Point& p : uniform_points(kPoints, 5)) {
    ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
    ++counts[static_cast<std::size_t>(4 * p.x) * 4 + static_cast<std::size_t>(4 * p.y)];
  }
  for (const int count : counts) EXPECT_NEAR(count, kPoints / 16., 5 * std::sqrt(kPoints / 16.));
}

}  // namespace
}  // namespace mwt
