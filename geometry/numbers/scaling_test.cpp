#include "geometry/numbers/scaling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mwt {
namespace {

TEST(Scaling, LeavesModerateCoordinatesAlone) {
  const std::vector<Point> points = {{0, 0}, {1e20, -3}, {1e-300, 5}};
  EXPECT_EQ(exact_scale(points), 0);
  EXPECT_EQ(exactly_scaled(points), points);
}

TEST(Scaling, BringsExtremesNearOneWithoutLosingABit) {
  constexpr double kMin = std::numeric_limits<double>::denorm_min();
  for (const double unit : {1e300, 1e-300, kMin}) {
    const std::vector<Point> points = {{unit, 0}, {-3 * unit, 2 * unit}, {7 * unit, unit}};
    const int e = exact_scale(points);
    const std::vector<Point> scaled = exactly_scaled(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LT(std::abs(scaled[i].x), 2);
      EXPECT_EQ(std::scalbn(scaled[i].x, e), points[i].x);
      EXPECT_EQ(std::scalbn(scaled[i].y, e), points[i].y);
    }
    EXPECT_GE(std::abs(scaled[2].x), 1);
  }
}

TEST(Scaling, BoundsAreRoundedOutwardsWhereTheyBecomeDenormal) {
  constexpr double kStep = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(scaled_up({1.5, 2.5}, 10), (Interval{1536, 2560}));
  EXPECT_EQ(scaled_up({4, 8}, -1074), (Interval{4 * kStep, 8 * kStep}));
  for (const double value : {4.25, 4.5, 4.75}) {
    const Interval bounds = scaled_up({value, value}, -1074);
    EXPECT_LE(bounds.lower, 4 * kStep) << value;
    EXPECT_GE(bounds.upper, 5 * kStep) << value;
    EXPECT_LE(bounds.width(), 2 * kStep) << value;
  }
  EXPECT_EQ(scaled_up({1, 1}, 1024), (Interval{std::numeric_limits<double>::max(), HUGE_VAL}));
}

TEST(Scaling, IsGivenUpWhereBitsWouldBeLost) {
  EXPECT_EQ(exact_scale(std::vector<Point>{{1e300, 0}, {1e-20, 1}, {0, 1}}), 0);
  // 3 * 2^-1074 / 2^100 keeps neither of its two bits.
  EXPECT_EQ(exact_scale(std::vector<Point>{{0x1p101, 0}, {0x3p-1074, 1}, {0, 1}}), 0);
  EXPECT_EQ(exact_scale(std::vector<Point>{{0, 0}}), 0);
}

}  // namespace
}  // namespace mwt
