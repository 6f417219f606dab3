#include "geometry/numbers/interval.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TEST(Interval, MeasuresItself) {
  const Interval interval{1, 3};
  EXPECT_EQ(interval.width(), 2);
  EXPECT_EQ(interval.middle(), 2);
  EXPECT_TRUE(interval.contains(1) && interval.contains(3) && !interval.contains(3.5));
  EXPECT_DOUBLE_EQ(interval.relative_width(), 2.0 / 3);
  EXPECT_EQ((Interval{0, 0}).relative_width(), 0);
  EXPECT_EQ((Interval{-4, -2}).relative_width(), 1);
}

TEST(Interval, OverlapIncludesTouching) {
  EXPECT_TRUE(overlap({1, 2}, {2, 3}));
  EXPECT_TRUE(overlap({1, 5}, {2, 3}));
  EXPECT_FALSE(overlap({1, 2}, {2.5, 3}));
  EXPECT_FALSE(overlap({2.5, 3}, {1, 2}));
}

// 0.1 + 0.2 in real arithmetic on the doubles lies strictly between two doubles.
TEST(Interval, ArithmeticRoundsOutwards) {
  const Interval sum = Interval{0.1, 0.1} + Interval{0.2, 0.2};
  EXPECT_LT(sum.lower, 0.1 + 0.2);
  EXPECT_GT(sum.upper, 0.1 + 0.2);
  const Interval difference = Interval{1, 2} - Interval{0.5, 0.75};
  EXPECT_LE(difference.lower, 0.25);
  EXPECT_GE(difference.upper, 1.5);
  EXPECT_LT(difference.width(), 1.25 + 1e-15);
}

}  // namespace
}  // namespace mwt
