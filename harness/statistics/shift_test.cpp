#include "harness/statistics/shift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "generators/random.h"
#include "harness/statistics/quantile.h"

namespace mwt {
namespace {

TEST(Shift, PseudoMedianBySmallCases) {
  EXPECT_EQ(pseudo_median(std::vector<double>{5}), 5);
  EXPECT_EQ(pseudo_median(std::vector<double>{1, 2}), 1.5);
  EXPECT_EQ(pseudo_median(std::vector<double>{1, 2, 9}), 3.5);  // of 1, 1.5, 2, 5, 5.5, 9
  EXPECT_THROW((void)pseudo_median({}), std::invalid_argument);
}

TEST(Shift, BetweenSamplesBySmallCases) {
  EXPECT_EQ(shift_between(std::vector<double>{1, 2, 3}, std::vector<double>{11, 12, 13}), 10);
  EXPECT_EQ(shift_between(std::vector<double>{0, 4}, std::vector<double>{1}), -1);  // of 1, -3
  EXPECT_THROW((void)shift_between({}, std::vector<double>{1}), std::invalid_argument);
}

TEST(Shift, AnOutlierCarriesNothingAway) {
  const std::vector<double> values = {1, 1.1, 1.2, 1.3, 1.4, 1.5, 1e9};
  EXPECT_LT(pseudo_median(values), 1.5);
  EXPECT_LT(shift_between(std::vector<double>{0, 0.1}, values), 1.5);
}

TEST(Shift, IntervalsCoverTheTruthAboutAsOftenAsTheySay) {
  RandomEngine engine = make_engine("shift_test", 1);
  int centre = 0, shift = 0;
  for (int experiment = 0; experiment < 200; ++experiment) {
    std::vector<double> first(20), second(20);
    for (double& value : first) value = standard_normal(engine);
    for (double& value : second) value = 3 + standard_normal(engine);
    const Estimate one = bootstrap_pseudo_median(first, {0.9, 200, 1});
    const Estimate two = bootstrap_shift(first, second, {0.9, 200, 1});
    centre += one.lower <= 0 && 0 <= one.upper;
    shift += two.lower <= 3 && 3 <= two.upper;
  }
  EXPECT_NEAR(centre / 200.0, 0.88, 0.07);
  EXPECT_NEAR(shift / 200.0, 0.88, 0.07);
}

}  // namespace
}  // namespace mwt
