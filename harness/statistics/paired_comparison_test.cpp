#include "harness/statistics/paired_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "generators/random.h"

namespace mwt {
namespace {

// The depression scores of Hollander and Wolfe's book, first less second visit.
const std::vector<double> kScores = {0.952, -0.147, 1.022, 0.43, 0.62, 0.59, 0.49, -0.08, 0.01};

const std::vector<double> kHundredTwenty = {
    -1.692, -0.085, -1.117, 0.421,  0.307,  -0.037, -2.367, -0.389, 0.101,  0.263,  -1.38,  -0.328, -0.829, -0.659,
    1.211,  -0.658, 0.117,  1.034,  -0.434, 0.038,  0.26,   0.214,  -1.075, 0.226,  1.509,  -1.397, 1.009,  0.269,
    -0.491, 2.15,   0.912,  -1.049, 0.225,  0.727,  -0.039, 0.833,  0.083,  0.817,  1.589,  -0.526, 0.353,  -0.313,
    0.277,  -1.037, -0.429, -0.046, 1.049,  1.295,  -1.174, -0.645, 0.797,  -1.842, -0.313, 0.053,  1.407,  0.839,
    -0.177, -0.219, -0.1,   1.674,  -0.278, -0.154, 0.503,  0.029,  -0.047, -0.964, 0.138,  -0.294, 1.316,  0.803,
    0.126,  0.818,  -0.19,  1.202,  0.145,  0.733,  -1.141, 0.497,  -1.538, -1.885, -0.154, -0.75,  0.314,  2.395,
    -0.682, -0.474, 0.355,  0.643,  -0.026, -0.056, 0.852,  0.67,   -0.884, 0.071,  0.185,  -0.904, 0.41,   -0.708,
    1.122,  0.343,  0.239,  -0.441, 0.031,  -1.848, -0.981, 0.513,  -1.979, 0.997,  -1.596, 0.907,  -0.695, 0.929,
    0.281,  -1.387, 1.399,  1.592,  0.084,  -0.124, -0.01,  -0.825};

// scipy.stats.wilcoxon (1.10.1): mode="exact" up to 100 values, mode="approx", correction=True beyond,
// zero_method="pratt" with zeros.
TEST(PairedComparison, PValuesAreThoseOfSciPy) {
  EXPECT_DOUBLE_EQ(compare_pairs(kScores).p_value, 0.0390625);
  const std::vector<double> twenty = {0.401, 0.699, 0.126, -0.491, -0.055, -0.592, 0.46,   1.74,   -0.092, -0.22,
                                      0.891, 0.757, 0.505, -0.53,  0.371,  1.095,  -0.944, -0.058, -1.501, -0.89};
  EXPECT_DOUBLE_EQ(compare_pairs(twenty).p_value, 0.7011814117431641);
  EXPECT_NEAR(compare_pairs(kHundredTwenty).p_value, 0.7672815628471887, 1e-12);
  std::vector<double> with_zeros = kHundredTwenty;
  with_zeros.resize(135, 0.0);
  EXPECT_NEAR(compare_pairs(with_zeros).p_value, 0.7283886093590485, 1e-12);
}

TEST(PairedComparison, CountsShiftAndEffect) {
  const PairedComparison scores = compare_pairs(kScores);
  EXPECT_EQ(scores.positive, 7u);
  EXPECT_EQ(scores.negative, 2u);
  EXPECT_EQ(scores.pairs(), 9u);
  EXPECT_DOUBLE_EQ(scores.effect, (40.0 - 5.0) / 45.0);
  EXPECT_NEAR(scores.shift, 0.46, 1e-12);  // the book's estimate
  EXPECT_DOUBLE_EQ(compare_pairs(std::vector<double>{1, 2, 3}).effect, 1);
  EXPECT_DOUBLE_EQ(compare_pairs(std::vector<double>{-1, -2, 0}).effect, -1);
  const PairedComparison equal = compare_pairs(std::vector<double>(8, 0.0));
  EXPECT_EQ(equal.zero, 8u);
  EXPECT_EQ(equal.p_value, 1);
  EXPECT_EQ(equal.effect, 0);
}

// Of nine differences the tables' critical value at 5% is 5, so the interval reaches from the sixth smallest to the
// sixth largest of the 45 means.
TEST(PairedComparison, IntervalByTheTable) {
  const auto interval = compare_pairs(kScores, 0.95).interval;
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->lower, 0.01, 1e-9);
  EXPECT_NEAR(interval->upper, 0.786, 1e-9);
}

TEST(PairedComparison, FewPairsHaveNoInterval) {
  EXPECT_FALSE(compare_pairs(std::vector<double>{1, 2, 3, 4, 5}).interval);
  const auto six = compare_pairs(std::vector<double>{1, 2, 3, 4, 5, 6}).interval;
  ASSERT_TRUE(six);
  EXPECT_EQ(six->lower, 1);
  EXPECT_EQ(six->upper, 6);
}

TEST(PairedComparison, IntervalsCoverAsOftenAsTheySay) {
  RandomEngine engine = make_engine("paired_comparison_test", 1);
  for (const std::size_t count : {std::size_t{12}, std::size_t{110}}) {
    int covered = 0;
    for (int experiment = 0; experiment < 400; ++experiment) {
      std::vector<double> differences(count);
      for (double& difference : differences) difference = 3 + standard_normal(engine);
      const auto interval = compare_pairs(differences).interval;
      covered += interval->lower <= 3 && 3 <= interval->upper;
    }
    EXPECT_GE(covered, 366) << count;
    EXPECT_LE(covered, 395) << count;
  }
}

TEST(PairedComparison, RefusesWhatIsNoComparison) {
  EXPECT_THROW((void)compare_pairs({}), std::invalid_argument);
  EXPECT_THROW((void)compare_pairs(std::vector<double>{std::nan("")}), std::invalid_argument);
  EXPECT_THROW((void)compare_pairs(std::vector<double>{1}, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace mwt
