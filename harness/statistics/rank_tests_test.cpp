#include "harness/statistics/rank_tests.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "generators/random.h"

namespace mwt {
namespace {

TEST(SignedRank, ExactSmallCases) {
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{1, 2, 3, 4, 5}), 1.0 / 32);
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{-1, 2, 3, 4, 5}), 2.0 / 32);
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{-1, -2, 3}), 5.0 / 8);  // sums 3, 4, 5, 6 and 3 again
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{-1, -2, -3}), 1);
}

// Ten pairs, the tables' one-sided critical values: 3 for 0.5% (5/1024) and 8 for 2.5% (25/1024).
TEST(SignedRank, TableOfTenPairs) {
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{1, 2, -3, 4, 5, 6, 7, 8, 9, 10}), 5.0 / 1024);
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{1, 2, 3, 4, 5, 6, 7, -8, 9, 10}), 25.0 / 1024);
}

TEST(SignedRank, ZerosAndTies) {
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{0, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{0, 1, 1}), 0.25);
  EXPECT_DOUBLE_EQ(signed_rank_p_value(std::vector<double>{1, 1, -1}), 0.5);  // three equal ranks: 3 + 1 of 8 patterns
  EXPECT_DOUBLE_EQ(signed_rank_p_value({}), 1);
}

TEST(SignedRank, IsNotSwayedByAnOutlier) {
  EXPECT_EQ(signed_rank_p_value(std::vector<double>{1, 2, 3, -4}),
            signed_rank_p_value(std::vector<double>{1, 2, 3, -4e9}));
}

// Both samples' p-values by going through all choices.
double rank_sum_by_enumeration(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> all = first;
  all.insert(all.end(), second.begin(), second.end());
  const auto wins = [&](const std::vector<bool>& is_second) {  // of the second sample, ties half
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (is_second[i] && !is_second[j]) sum += all[i] > all[j] ? 1 : all[i] == all[j] ? 0.5 : 0;
      }
    }
    return sum;
  };
  std::vector<bool> choice(all.size(), false);
  std::fill(choice.begin() + static_cast<std::ptrdiff_t>(first.size()), choice.end(), true);
  const double observed = wins(choice);
  int at_least = 0, arrangements = 0;
  do {
    at_least += wins(choice) >= observed;
    ++arrangements;
  } while (std::next_permutation(choice.begin(), choice.end()));
  return static_cast<double>(at_least) / arrangements;
}

TEST(RankSum, ExactSmallCases) {
  EXPECT_DOUBLE_EQ(rank_sum_p_value(std::vector<double>{1, 2, 3}, std::vector<double>{4, 5, 6}), 1.0 / 20);
  EXPECT_DOUBLE_EQ(rank_sum_p_value(std::vector<double>{1, 2, 4}, std::vector<double>{3, 5, 6}), 2.0 / 20);
  EXPECT_DOUBLE_EQ(rank_sum_p_value(std::vector<double>{4, 5, 6}, std::vector<double>{1, 2, 3}), 1);
  EXPECT_DOUBLE_EQ(rank_sum_p_value(std::vector<double>{2, 2}, std::vector<double>{2, 2}), 1);
  EXPECT_DOUBLE_EQ(rank_sum_p_value({}, std::vector<double>{1}), 1);
}

TEST(RankSum, AgreesWithEnumerationWithAndWithoutTies) {
  RandomEngine engine = make_engine("rank_tests_test", 1);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> first(1 + uniform_below(engine, 4)), second(1 + uniform_below(engine, 4));
    const std::uint64_t values = 2 + uniform_below(engine, 50);
    for (double& value : first) value = static_cast<double>(uniform_below(engine, values));
    for (double& value : second) value = static_cast<double>(uniform_below(engine, values));
    EXPECT_NEAR(rank_sum_p_value(first, second), rank_sum_by_enumeration(first, second), 1e-12);
  }
}

TEST(RankTests, ApproximationJoinsTheExactValues) {
  RandomEngine engine = make_engine("rank_tests_test", 2);
  std::vector<double> exact, approximate;  // one pair more makes no difference worth mentioning
  for (std::size_t i = 0; i < kExactRankTestSize; ++i) exact.push_back(0.2 + standard_normal(engine));
  approximate = exact;
  approximate.push_back(0.01);
  EXPECT_NEAR(signed_rank_p_value(exact), signed_rank_p_value(approximate), 0.1 * signed_rank_p_value(exact));

  const std::vector<double> first(exact.begin(), exact.begin() + 50);
  const std::vector<double> second(exact.begin() + 50, exact.end());
  std::vector<double> one_more = second;
  one_more.push_back(0.2);
  EXPECT_NEAR(rank_sum_p_value(first, second), rank_sum_p_value(first, one_more), 0.05);
}

TEST(RankTests, RejectAsOftenAsTheySayWithoutAnyEffect) {
  RandomEngine engine = make_engine("rank_tests_test", 3);
  int signed_rank_alarms = 0, rank_sum_alarms = 0;
  for (int experiment = 0; experiment < 2000; ++experiment) {
    std::vector<double> first(8), second(8), differences(8);
    for (std::size_t i = 0; i < 8; ++i) {
      first[i] = std::exp(standard_normal(engine));
      second[i] = std::exp(standard_normal(engine));
      differences[i] = second[i] - first[i];
    }
    signed_rank_alarms += signed_rank_p_value(differences) <= 0.05;
    rank_sum_alarms += rank_sum_p_value(first, second) <= 0.05;
  }
  EXPECT_NEAR(signed_rank_alarms / 2000.0, 0.05, 0.015);
  EXPECT_NEAR(rank_sum_alarms / 2000.0, 0.05, 0.015);
}

TEST(RankTests, RefuseNaN) {
  EXPECT_THROW((void)signed_rank_p_value(std::vector<double>{std::nan("")}), std::invalid_argument);
  EXPECT_THROW((void)rank_sum_p_value(std::vector<double>{1}, std::vector<double>{std::nan("")}),
               std::invalid_argument);
}

}  // namespace
}  // namespace mwt
