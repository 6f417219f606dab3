#include "harness/statistics/binomial_interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace mwt {
namespace {

// P(X >= k), X binomial, summed term by term.
double upper_tail(int k, int trials, double p) {
  double sum = 0;
  for (int i = k; i <= trials; ++i) {
    const double log_choices = std::lgamma(trials + 1.0) - std::lgamma(i + 1.0) - std::lgamma(trials - i + 1.0);
    sum += std::exp(log_choices + i * std::log(p) + (trials - i) * std::log1p(-p));
  }
  return sum;
}

TEST(ClopperPearson, PublishedValues) {
  // R: binom.test(1, 10)$conf.int, binom.test(7, 20)$conf.int
  EXPECT_NEAR(clopper_pearson(1, 10).lower, 0.002528579, 1e-9);
  EXPECT_NEAR(clopper_pearson(1, 10).upper, 0.445016117, 1e-9);
  EXPECT_NEAR(clopper_pearson(7, 20).lower, 0.1539092, 1e-7);
  EXPECT_NEAR(clopper_pearson(7, 20).upper, 0.5921885, 1e-7);
}

TEST(ClopperPearson, ClosedFormsWhereAllOrNoneSucceed) {
  for (const int trials : {1, 10, 1000}) {
    const double end = std::pow(0.025, 1.0 / trials);
    EXPECT_NEAR(clopper_pearson(0, static_cast<std::uint64_t>(trials)).upper, 1 - end, 1e-12);
    EXPECT_EQ(clopper_pearson(0, static_cast<std::uint64_t>(trials)).lower, 0);
    EXPECT_NEAR(clopper_pearson(static_cast<std::uint64_t>(trials), static_cast<std::uint64_t>(trials)).lower, end,
                1e-12);
    EXPECT_EQ(clopper_pearson(static_cast<std::uint64_t>(trials), static_cast<std::uint64_t>(trials)).upper, 1);
  }
}

TEST(ClopperPearson, EndsLeaveHalfOfTheRestInEachTail) {
  for (const int successes : {1, 3, 11, 29}) {
    const ProbabilityInterval interval = clopper_pearson(static_cast<std::uint64_t>(successes), 30, 0.9);
    EXPECT_NEAR(upper_tail(successes, 30, interval.lower), 0.05, 1e-10);
    EXPECT_NEAR(1 - upper_tail(successes + 1, 30, interval.upper), 0.05, 1e-10);
  }
}

TEST(ClopperPearson, KnowsNothingWithoutTrials) {
  EXPECT_EQ(clopper_pearson(0, 0).lower, 0);
  EXPECT_EQ(clopper_pearson(0, 0).upper, 1);
}

TEST(ClopperPearson, RefusesNonsense) {
  EXPECT_THROW((void)clopper_pearson(2, 1), std::invalid_argument);
  EXPECT_THROW((void)clopper_pearson(1, 2, 1), std::invalid_argument);
}

}  // namespace
}  // namespace mwt
