#include "harness/rating/quality.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace mwt {
namespace {

using Rational = boost::multiprecision::cpp_rational;

TEST(Quality, QuotientsAreTheTightestBounds) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const double a = std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 400) - 200);
    const double b = std::ldexp(static_cast<double>((random() >> 40) + 1), static_cast<int>(random() % 400) - 200);
    if (a == 0) continue;
    const double low = divide_down(a, b);
    const double high = divide_up(a, b);
    EXPECT_LE(Rational(low) * Rational(b), Rational(a));
    EXPECT_GE(Rational(high) * Rational(b), Rational(a));
    EXPECT_LE(high, next_up(low));
  }
}

TEST(Quality, ExactQuotientsStayExact) {
  EXPECT_EQ(divide_down(3, 2), 1.5);
  EXPECT_EQ(divide_up(3, 2), 1.5);
  EXPECT_EQ(divide_up(1, 1), 1.0);
}

TEST(Quality, TinyQuotientsAreStillBounds) {
  const double tiny = 3e-300;
  EXPECT_LT(divide_down(tiny, 7e-300), divide_up(tiny, 7e-300));
  EXPECT_LE(Rational(divide_down(tiny, 7e-300)) * Rational(7e-300), Rational(tiny));
  EXPECT_GE(Rational(divide_up(tiny, 7e-300)) * Rational(7e-300), Rational(tiny));
}

TEST(Quality, AlphaIsNeverBelowOne) {
  const Interval alpha = alpha_of({10, 10.5}, {10, 10.5});
  EXPECT_EQ(alpha.lower, 1);
  EXPECT_EQ(alpha.upper, 1.05);
}

TEST(Quality, AlphaEnclosesEveryCombination) {
  const Interval alpha = alpha_of({12, 12.5}, {10, 11});
  EXPECT_LE(alpha.lower, 12.0 / 11);
  EXPECT_GE(alpha.upper, 1.25);
}

TEST(Quality, ProvedMeansARelativeWidthOfAtMostOneInAMillionMillion) {
  EXPECT_EQ(optimality_of(std::nullopt), Optimality::none);
  EXPECT_EQ(optimality_of(Interval{0, 1}), Optimality::none);
  EXPECT_EQ(optimality_of(Interval{1, 1}), Optimality::proved);
  EXPECT_EQ(optimality_of(Interval{1, 1 + 0.9e-12}), Optimality::proved);
  EXPECT_EQ(optimality_of(Interval{1, 1 + 1.1e-12}), Optimality::bounded);
}

TEST(Quality, OptimalOnlyWhenProvedAndNotHeavier) {
  const Interval optimum{1, next_up(1)};
  EXPECT_EQ(is_optimal(optimum, optimum), Decision::yes);
  EXPECT_EQ(is_optimal({1.1, 1.2}, optimum), Decision::no);
  EXPECT_EQ(is_optimal({1, 1.2}, optimum), Decision::undecided);
  EXPECT_EQ(is_optimal({1, 1.05}, Interval{0.5, 1.05}), Decision::undecided);
  EXPECT_EQ(is_optimal({1, 1}, std::nullopt), Decision::undecided);
}

TEST(Quality, TheUpperEndOfAnOptimumIsTheCheckedTriangulation) {
  const WitnessedOptimum optimum = witnessed_optimum(Interval{9, 9.5}, {10, 10.5});
  ASSERT_TRUE(optimum.interval);
  EXPECT_EQ(*optimum.interval, (Interval{9, 10.5}));
  EXPECT_TRUE(witnessed_optimum(Interval{11, 12}, {10, 10.5}).contradiction);
  EXPECT_FALSE(witnessed_optimum(std::nullopt, {10, 10.5}).interval);
  EXPECT_FALSE(witnessed_optimum(Interval{0, 10}, {10, 10.5}).interval);
}

TEST(Quality, IntersectionsOfDisjointIntervalsAreNone) {
  EXPECT_FALSE(intersection({1, 2}, {3, 4}));
  EXPECT_EQ(*intersection({1, 3}, {2, 4}), (Interval{2, 3}));
}

}  // namespace
}  // namespace mwt
