#include "harness/statistics/quantile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace mwt {
namespace {

TEST(Quantile, IsLinearBetweenOrderStatistics) {
  // R: quantile(c(1, 2, 3, 4), c(0, 0.1, 0.25, 0.5, 0.75, 0.9, 1))
  const std::vector<double> sample = {4, 1, 3, 2};
  EXPECT_DOUBLE_EQ(quantile(sample, 0), 1);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.1), 1.3);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.75), 3.25);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.9), 3.7);
  EXPECT_DOUBLE_EQ(quantile(sample, 1), 4);
}

TEST(Quantile, OfAnIntegerRangeIsItsPosition) {
  std::vector<double> sample;
  for (int i = 100; i >= 0; --i) sample.push_back(i);
  for (int percent = 0; percent <= 100; ++percent) EXPECT_NEAR(quantile(sample, percent / 100.0), percent, 1e-12);
}

TEST(Quantile, OfOneValueIsThatValue) {
  for (const double p : {0.0, 0.3, 1.0}) EXPECT_EQ(quantile(std::vector<double>{7}, p), 7);
}

TEST(Quantile, MedianOfOddAndEvenSamples) {
  EXPECT_EQ(median(std::vector<double>{5, 1, 3}), 3);
  EXPECT_EQ(median(std::vector<double>{5, 1, 3, 4}), 3.5);
  EXPECT_EQ(median(std::vector<double>{2, 2, 2, 9}), 2);
}

TEST(Quantile, LeavesItsArgumentAlone) {
  const std::vector<double> sample = {3, 1, 2};
  EXPECT_EQ(median(sample), 2);
  EXPECT_EQ(sample, (std::vector<double>{3, 1, 2}));
}

TEST(Quantile, InfinitiesAreValues) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(median(std::vector<double>{1, 2, infinity}), 2);
  EXPECT_EQ(quantile(std::vector<double>{1, infinity}, 1), infinity);
}

TEST(Quantile, RefusesWhatHasNoQuantile) {
  const std::vector<double> sample = {1, 2};
  EXPECT_THROW((void)quantile({}, 0.5), std::invalid_argument);
  EXPECT_THROW((void)quantile(sample, -0.1), std::invalid_argument);
  EXPECT_THROW((void)quantile(sample, std::nan("")), std::invalid_argument);
  EXPECT_THROW((void)median(std::vector<double>{1, std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace mwt
