#include "harness/statistics/power_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "generators/random.h"

namespace mwt {
namespace {

TEST(PowerLaw, ExactPowersComeBack) {
  const std::vector<Measurement> cubes = {{1, 5}, {10, 5e3}, {100, 5e6}, {1000, 5e9}};
  const auto law = fit_power_law(cubes);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent.value, 3, 1e-12);
  EXPECT_NEAR(std::exp(law->log_factor.value), 5, 1e-9);
  EXPECT_NEAR(law->r_squared.value(), 1, 1e-12);
}

// The normal equations solved by hand: logarithms (0, 0), (1, 1), (2, 1) have the line 1/6 + x/2, r^2 = 3/4.
TEST(PowerLaw, ClosedFormOfThreePoints) {
  const double e = std::exp(1.0);
  const auto law = fit_power_law(std::vector<Measurement>{{1, 1}, {e, e}, {e * e, e}});
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent.value, 0.5, 1e-12);
  EXPECT_NEAR(law->log_factor.value, 1.0 / 6, 1e-12);
  EXPECT_NEAR(law->r_squared.value(), 0.75, 1e-12);
}

TEST(PowerLaw, AConstantHasExponentZero) {
  const auto law = fit_power_law(std::vector<Measurement>{{10, 7}, {20, 7}, {40, 7}});
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent.value, 0, 1e-12);
  EXPECT_FALSE(law->r_squared) << "there is no variance to explain";
}

TEST(PowerLaw, RoundingIsNoVariance) {
  const std::vector<Measurement> rounded = {{10, 1}, {20, 1 + 1e-13}, {40, 1}, {80, 1 + 1e-12}};
  EXPECT_FALSE(fit_power_law(rounded)->r_squared);
  const std::vector<Measurement> different = {{10, 1}, {20, 1 + 1e-9}, {40, 1}, {80, 1 + 1e-8}};
  EXPECT_TRUE(fit_power_law(different)->r_squared);
}

TEST(PowerLaw, NeedsTwoDistinctSizes) {
  EXPECT_FALSE(fit_power_law({}));
  EXPECT_FALSE(fit_power_law(std::vector<Measurement>{{10, 1}}));
  EXPECT_FALSE(fit_power_law(std::vector<Measurement>{{10, 1}, {10, 2}, {10, 3}}));
}

TEST(PowerLaw, SaysWhenNothingIsKnownOfTheNoise) {
  const auto once = fit_power_law(std::vector<Measurement>{{10, 1}, {20, 3}, {40, 5}});
  ASSERT_TRUE(once);
  EXPECT_FALSE(once->has_interval);
  EXPECT_EQ(once->exponent.lower, once->exponent.upper);
  const auto repeated = fit_power_law(std::vector<Measurement>{{10, 1}, {20, 3}, {20, 4}});
  ASSERT_TRUE(repeated);
  EXPECT_TRUE(repeated->has_interval);
}

// Two sizes, each measured twice: the slope is a difference of means, and every mean takes its lower, middle or upper
// value with probability 1/4, 1/2, 1/4, so the extreme slopes have probability 1/16 each.
TEST(PowerLaw, IntervalOfTwoSizesIsExact) {
  const double e = std::exp(1.0);
  const std::vector<Measurement> measurements = {{1, 1}, {1, e}, {e, e}, {e, e * e}};
  const auto wide = fit_power_law(measurements, {0.9, 20000, 1});
  ASSERT_TRUE(wide);
  EXPECT_NEAR(wide->exponent.value, 1, 1e-12);
  EXPECT_NEAR(wide->exponent.lower, 0, 1e-12);
  EXPECT_NEAR(wide->exponent.upper, 2, 1e-12);
  const auto narrow = fit_power_law(measurements, {0.8, 20000, 1});
  EXPECT_NEAR(narrow->exponent.lower, 0.5, 1e-12);
  EXPECT_NEAR(narrow->exponent.upper, 1.5, 1e-12);
}

TEST(PowerLaw, CoversTheTruthAboutAsOftenAsItSays) {
  RandomEngine engine = make_engine("power_law_test", 1);
  int covered = 0;
  for (int experiment = 0; experiment < 200; ++experiment) {
    std::vector<Measurement> measurements;
    for (const double n : {100.0, 300.0, 1000.0, 3000.0}) {
      for (int i = 0; i < 10; ++i) measurements.push_back({n, 3 * n * n * std::exp(0.2 * standard_normal(engine))});
    }
    const auto law = fit_power_law(measurements, {0.9, 200, 1});
    covered += law->exponent.lower <= 2 && 2 <= law->exponent.upper;
  }
  EXPECT_NEAR(covered / 200.0, 0.88, 0.07);
}

TEST(PowerLaw, RefusesWhatHasNoLogarithm) {
  EXPECT_THROW((void)fit_power_law(std::vector<Measurement>{{1, 0}, {2, 1}}), std::invalid_argument);
  EXPECT_THROW((void)fit_power_law(std::vector<Measurement>{{-1, 1}, {2, 1}}), std::invalid_argument);
  EXPECT_THROW((void)fit_power_law(std::vector<Measurement>{{1, HUGE_VAL}, {2, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace mwt
