#include "harness/statistics/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include "generators/random.h"
#include "harness/statistics/quantile.h"

namespace mwt {
namespace {

double mean(std::span<const double> sample) {
  return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
}

TEST(Bootstrap, OfEqualValuesIsAPoint) {
  const Estimate estimate = bootstrap_median(std::vector<double>(9, 4.5));
  EXPECT_EQ(estimate.value, 4.5);
  EXPECT_EQ(estimate.lower, 4.5);
  EXPECT_EQ(estimate.upper, 4.5);
}

TEST(Bootstrap, SameSeedSameInterval) {
  const std::vector<double> sample = {1, 5, 2, 8, 3, 9, 4};
  const Estimate first = bootstrap_median(sample, {0.9, 500, 7});
  const Estimate second = bootstrap_median(sample, {0.9, 500, 7});
  EXPECT_EQ(first.lower, second.lower);
  EXPECT_EQ(first.upper, second.upper);
}

// A resample of two values is {a, a}, {a, b}, {b, a} or {b, b}: the mean is a or b with probability 1/4 each.
TEST(Bootstrap, OfTwoValuesHasTheExactQuantiles) {
  const std::vector<double> sample = {0, 1};
  const Estimate wide = bootstrap(sample, mean, {0.6, 20000, 1});  // 0.2 in each tail: less than 1/4
  EXPECT_EQ(wide.value, 0.5);
  EXPECT_EQ(wide.lower, 0);
  EXPECT_EQ(wide.upper, 1);
  const Estimate narrow = bootstrap(sample, mean, {0.4, 20000, 1});  // 0.3: more than 1/4
  EXPECT_EQ(narrow.lower, 0.5);
  EXPECT_EQ(narrow.upper, 0.5);
}

// Of the median of an odd sample the bootstrap distribution is known (Efron 1979): it is at most the k-th smallest
// value when at least half of the draws are among the k smallest. P(Binomial(15, k/15) >= 8) is 0.021 for k = 4 and
// 0.088 for k = 5, so that 2.5% lie below the 5th value, and by symmetry 2.5% above the 11th.
TEST(Bootstrap, OfAMedianHasTheExactQuantiles) {
  std::vector<double> sample(15);
  std::iota(sample.begin(), sample.end(), 1.0);
  const Estimate estimate = bootstrap_median(sample, {0.9, 20000, 3});
  EXPECT_EQ(estimate.value, 8);
  EXPECT_EQ(estimate.lower, 5);
  EXPECT_EQ(estimate.upper, 11);
}

// The mean's standard error is known: s / sqrt(n) with the divisor n.
TEST(Bootstrap, OfAMeanIsNearTheNormalInterval) {
  std::vector<double> sample(200);
  std::iota(sample.begin(), sample.end(), 0.0);
  const double standard_error = std::sqrt((200.0 * 200 - 1) / 12 / 200);
  const Estimate estimate = bootstrap(sample, mean, {0.95, 20000, 1});
  EXPECT_DOUBLE_EQ(estimate.value, 99.5);
  EXPECT_NEAR(estimate.lower, 99.5 - 1.96 * standard_error, 0.05 * standard_error);
  EXPECT_NEAR(estimate.upper, 99.5 + 1.96 * standard_error, 0.05 * standard_error);
}

TEST(Bootstrap, CoversTheMedianAboutAsOftenAsItSays) {
  RandomEngine engine = make_engine("bootstrap_test", 1);
  int covered = 0;
  for (int experiment = 0; experiment < 400; ++experiment) {
    std::vector<double> sample(25);
    for (double& value : sample) value = standard_normal(engine);
    const Estimate estimate = bootstrap_median(sample, {0.9, 300, static_cast<std::uint64_t>(experiment)});
    covered += estimate.lower <= 0 && 0 <= estimate.upper;
  }
  EXPECT_NEAR(covered / 400.0, 0.9, 0.05);
}

TEST(Bootstrap, StrataKeepTheirSizes) {
  const std::vector<std::size_t> groups = {5, 2, 5, 2, 5};
  std::set<std::size_t> seen;
  const auto check = [&](std::span<const std::size_t> drawn) {
    for (std::size_t i = 0; i < drawn.size(); ++i) EXPECT_EQ(groups[drawn[i]], groups[i]);
    seen.insert(drawn.begin(), drawn.end());
    return 0.0;
  };
  (void)bootstrap_over(groups.size(), check, {0.95, 100, 1}, groups);
  EXPECT_EQ(seen.size(), groups.size());
}

TEST(Bootstrap, PairsHideWhatMovesBoth) {
  // A machine that slows down a hundredfold in the course of the experiment; the new build takes 10% longer.
  std::vector<double> base, slower;
  for (int i = 0; i < 20; ++i) {
    base.push_back(std::pow(1.26, i));
    slower.push_back(1.1 * base.back());
  }
  const Estimate paired = bootstrap_paired_ratio_of_medians(slower, base);
  EXPECT_NEAR(paired.value, 1.1, 1e-12);
  EXPECT_NEAR(paired.lower, 1.1, 1e-12);
  EXPECT_NEAR(paired.upper, 1.1, 1e-12);
  const Estimate unpaired = bootstrap_ratio_of_medians(slower, base);
  EXPECT_NEAR(unpaired.value, 1.1, 1e-12);
  EXPECT_LT(unpaired.lower, 0.7);
  EXPECT_GT(unpaired.upper, 1.5);
}

TEST(Bootstrap, RatioOfConstantsIsExact) {
  const Estimate ratio = bootstrap_ratio_of_medians(std::vector<double>(3, 6.0), std::vector<double>(5, 4.0));
  EXPECT_EQ(ratio.value, 1.5);
  EXPECT_EQ(ratio.lower, 1.5);
  EXPECT_EQ(ratio.upper, 1.5);
}

TEST(Bootstrap, RefusesWhatHasNoAnswer) {
  const std::vector<double> one = {1};
  EXPECT_THROW((void)bootstrap_median({}), std::invalid_argument);
  EXPECT_THROW((void)bootstrap_median(one, {1.0, 100, 1}), std::invalid_argument);
  EXPECT_THROW((void)bootstrap_median(one, {0.9, 0, 1}), std::invalid_argument);
  EXPECT_THROW((void)bootstrap_paired_ratio_of_medians(one, std::vector<double>{1, 2}), std::invalid_argument);
  EXPECT_THROW((void)bootstrap_ratio_of_medians(one, std::vector<double>{0}), std::invalid_argument);
}

}  // namespace
}  // namespace mwt
