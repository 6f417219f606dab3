#include "generators/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mwt {
namespace {

// The values that everything else rests on: a library that changed them would show here first.
TEST(Random, engine_and_distributions_are_the_recorded_ones) {
  EXPECT_EQ(scatter_bits(0), 0xe220a8397b1dcdafU);  // splitmix64's first output from state 0
  RandomEngine standard;                            // seeded as the C++ standard does
  standard.discard(9999);
  EXPECT_EQ(standard(), 9981545732273789042U);  // C++ standard, [rand.predef]
  RandomEngine halves = make_engine("test", 1);
  RandomEngine raw = make_engine("test", 1);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(uniform_unit(halves), static_cast<double>(raw()) / 0x1p64);
}

TEST(Random, streams_differ_by_family_and_by_seed) {
  EXPECT_EQ(make_engine("a", 1)(), make_engine("a", 1)());
  EXPECT_NE(make_engine("a", 1)(), make_engine("a", 2)());
  EXPECT_NE(make_engine("a", 1)(), make_engine("b", 1)());
  EXPECT_NE(make_engine("ab", 0)(), make_engine("ba", 0)());
}

TEST(Random, distributions_have_their_moments) {
  constexpr int kDraws = 100'000;
  RandomEngine engine = make_engine("moments", 1);
  double mean = 0, normal_mean = 0, normal_square = 0;
  std::array<int, 7> counts{};
  for (int i = 0; i < kDraws; ++i) {
    mean += uniform_unit(engine) / kDraws;
    const double normal = standard_normal(engine);
    normal_mean += normal / kDraws;
    normal_square += normal * normal / kDraws;
    ++counts[uniform_below(engine, counts.size())];
  }
  EXPECT_NEAR(mean, .5, 5 * std::sqrt(1. / 12 / kDraws));
  EXPECT_NEAR(normal_mean, 0, 5 * std::sqrt(1. / kDraws));
  EXPECT_NEAR(normal_square, 1, 5 * std::sqrt(2. / kDraws));
  for (const int count : counts) EXPECT_NEAR(count, kDraws / 7., 5 * std::sqrt(kDraws / 7.));
}

TEST(Random, shuffle_permutes) {
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i) points.push_back({static_cast<double>(i), 0});
  const std::vector<Point> before = points;
  RandomEngine engine = make_engine("shuffle", 1);
  shuffle(points, engine);
  EXPECT_NE(points, before);
  std::sort(points.begin(), points.end(), lexicographically_less);
  EXPECT_EQ(points, before);
}

}  // namespace
}  // namespace mwt
