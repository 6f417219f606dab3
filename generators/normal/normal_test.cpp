#include "generators/normal/normal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Normal, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("normal", 100, 1), "1beed585ae5b39ac982baca484fd0ef6");
  EXPECT_EQ(golden_hash("normal", 100, 2), "9311c932e494c2d5084b90e9bdb79c0c");
}

TEST(Normal, half_of_the_points_lie_within_the_median_distance) {
  constexpr Index kPoints = 10'000;
  const double median_square = 2 * std::log(2);  // the squared distance is exponential with mean 2
  int inner = 0;
  for (const Point& p : normal_points(kPoints, 5)) inner += p.x * p.x + p.y * p.y < median_square ? 1 : 0;
  EXPECT_NEAR(inner, kPoints / 2., 5 * std::sqrt(kPoints / 4.));
}

}  // namespace
}  // namespace mwt
