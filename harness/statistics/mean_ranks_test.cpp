#include "harness/statistics/mean_ranks.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

namespace mwt {
namespace {

using Blocks = std::vector<std::vector<double>>;

// SciPy 1.10: friedmanchisquare(*numpy.array(blocks).T)
TEST(MeanRanks, AgreeWithSciPy) {
  const MeanRanks ranks = mean_ranks(Blocks{{1, 2, 3}, {2, 1, 3}, {1, 1, 4}, {5, 7, 6}, {1, 2, 2}});
  EXPECT_EQ(ranks.blocks, 5u);
  EXPECT_NEAR(ranks.chi_squared, 5.444444444444451, 1e-12);
  EXPECT_NEAR(ranks.p_value, 0.06572852861653028, 1e-12);
  EXPECT_DOUBLE_EQ(ranks.ranks[0], (1 + 2 + 1.5 + 1 + 1) / 5);
}

// scipy.stats.studentized_range.ppf(0.95, k, inf); Demsar's table has them divided by the square root of 2.
TEST(MeanRanks, QuantilesOfTheStudentizedRange) {
  EXPECT_NEAR(studentized_range_quantile(0.95, 2), 2.771807648699355, 1e-9);
  EXPECT_NEAR(studentized_range_quantile(0.95, 3), 3.314493155398122, 1e-9);
  EXPECT_NEAR(studentized_range_quantile(0.95, 10), 4.474124221725907, 1e-9);
  EXPECT_NEAR(studentized_range_quantile(0.95, 20), 5.0116887941184425, 1e-9);
}

TEST(MeanRanks, CriticalDifferenceOfDemsarsExample) {  // four classifiers on 14 data sets
  const Blocks blocks(14, {1, 2, 3, 4});
  EXPECT_NEAR(mean_ranks(blocks).critical_difference, 1.25, 0.005);
}

TEST(MeanRanks, TiesAndInfinities) {
  const MeanRanks tied = mean_ranks(Blocks{{1, 1}, {2, 2}});
  EXPECT_EQ(tied.chi_squared, 0);
  EXPECT_EQ(tied.p_value, 1);
  const double failed = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(mean_ranks(Blocks{{1, failed, failed}}).ranks[2], 2.5);
}

TEST(MeanRanks, RefuseWhatHasNoRanks) {
  EXPECT_THROW((void)mean_ranks(Blocks{}), std::invalid_argument);
  EXPECT_THROW((void)mean_ranks(Blocks{{1}}), std::invalid_argument);
  EXPECT_THROW((void)mean_ranks(Blocks{{1, 2}, {1, 2, 3}}), std::invalid_argument);
}

}  // namespace
}  // namespace mwt
