#include "geometry/numbers/double_double.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

// 100 decimal digits are not enough for sums of numbers of all magnitudes; 2200 bits hold them exactly.
using Real = boost::multiprecision::cpp_bin_float_100;
using WideReal =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<2200, boost::multiprecision::digit_base_2>>;

template <class Number = Real>
Number real(const DoubleDouble& a) {
  return Number(a.high) + Number(a.low);
}

Real real_length(const Point& p, const Point& q) {
  const Real dx = Real(p.x) - Real(q.x), dy = Real(p.y) - Real(q.y);
  return sqrt(Real(dx * dx + dy * dy));
}

void expect_relative_error(const Real& computed, const Real& expected, double bound) {
  const Real error = abs(Real(computed - expected));
  EXPECT_LE(error, abs(expected) * Real(bound));
}

void expect_normalised(const DoubleDouble& a) { EXPECT_EQ(a.high + a.low, a.high); }

double random_double(std::mt19937_64& random, int lowest_exponent, int highest_exponent) {
  const auto span = static_cast<std::uint64_t>(highest_exponent - lowest_exponent + 1);
  return std::scalbn(1 + test::random_unit(random), lowest_exponent + static_cast<int>(random() % span));
}

// Positive, with a random low part, which may be negative.
DoubleDouble random_double_double(std::mt19937_64& random, int lowest_exponent, int highest_exponent) {
  const double high = random_double(random, lowest_exponent, highest_exponent);
  const double low = (test::random_unit(random) - 0.5) * high * 0x1p-53;
  return exact_sum_ordered(high, low);
}

TEST(DoubleDouble, ExactSumsAreExact) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const double a = random_double(random, -1074, 1020) * (random() % 2 == 0 ? 1 : -1);
    const double b = random_double(random, -1074, 1020);
    EXPECT_EQ(real<WideReal>(exact_sum(a, b)), WideReal(a) + WideReal(b));
    const auto [small, large] = std::minmax(a, b, [](double x, double y) { return std::abs(x) < std::abs(y); });
    EXPECT_EQ(real<WideReal>(exact_sum_ordered(large, small)), WideReal(a) + WideReal(b));
  }
}

TEST(DoubleDouble, ExactProductsAreExact) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 2000; ++trial) {
    const double a = random_double(random, -400, 500), b = random_double(random, -400, 500);
    EXPECT_EQ(real(exact_product(a, b)), Real(a) * Real(b));
  }
}

TEST(DoubleDouble, OperationsKeepTheirErrorBound) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 3000; ++trial) {
    const int lowest = trial % 2 == 0 ? -400 : -3, highest = -lowest;
    const DoubleDouble a = random_double_double(random, lowest, highest);
    const DoubleDouble b = random_double_double(random, lowest, highest);
    for (const DoubleDouble& result : {a + b, square(a), square_root(a)}) expect_normalised(result);
    expect_relative_error(real(a + b), real(a) + real(b), kDoubleDoubleError);
    expect_relative_error(real(square(a)), real(a) * real(a), kDoubleDoubleError);
    expect_relative_error(real(square_root(a)), sqrt(real(a)), kDoubleDoubleError);
  }
}

TEST(DoubleDouble, ComparesByHighThenLow) {
  const DoubleDouble a{1, 0}, b{1, 0x1p-60}, c{2, -0x1p-60};
  EXPECT_TRUE(a < b && b < c && !(b < a) && !(a < a));
  EXPECT_TRUE(a == DoubleDouble(1) && !(a == b));
  EXPECT_EQ(b - a, DoubleDouble(0x1p-60));
  EXPECT_EQ(square_root(DoubleDouble(0)), DoubleDouble());
  EXPECT_EQ(square_root(DoubleDouble(49)), DoubleDouble(7));
}

TEST(Length, KeepsItsErrorBoundAtEveryMagnitude) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 4000; ++trial) {
    const int exponents[] = {0, -300, 300, 390, 405, -395, -405, 900, 995, -900};
    const int exponent = exponents[static_cast<std::size_t>(trial) % std::size(exponents)];
    const auto coordinate = [&] {
      return random() % 8 == 0 ? 0.0 : random_double(random, exponent - (trial % 60), exponent);
    };
    const Point p{coordinate(), -coordinate()}, q{-coordinate(), coordinate()};
    SCOPED_TRACE("exponent " + std::to_string(exponent));
    expect_relative_error(real(length(p, q)), real_length(p, q), 8 * kDoubleDoubleError);
    EXPECT_EQ(length(p, q), length(q, p));
  }
}

// Below 2^-1022 doubles have fewer bits: what remains is an absolute bound of a step or two.
TEST(Length, DenormalLengthsErrByAtMostOneStep) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto coordinate = [&] { return static_cast<double>(random() % (trial % 2 == 0 ? 8 : 1 << 30)) * 0x1p-1074; };
    const Point p{coordinate(), coordinate()}, q{coordinate(), coordinate()};
    const Real error = abs(Real(real(length(p, q)) - real_length(p, q)));
    ASSERT_LE(error, Real(0x1p-1074));
  }
}

TEST(Length, ExactWhereTheAnswerIsADouble) {
  EXPECT_EQ(length({0, 0}, {3, 4}), DoubleDouble(5));
  EXPECT_EQ(length({1, 1}, {1, 1}), DoubleDouble());
  EXPECT_EQ(length({-1e300, 0}, {1e300, 0}), DoubleDouble(2e300));
  EXPECT_EQ(length({0, 3 * 0x1p-1060}, {4 * 0x1p-1060, 0}), DoubleDouble(5 * 0x1p-1060));
  EXPECT_EQ(length({0, 0}, {5e-324, 0}), DoubleDouble(5e-324));
}

TEST(Enclose, IsTightAndHoldsTheValue) {
  const double below = std::nextafter(7.0, 6.0), above = std::nextafter(7.0, 8.0);
  EXPECT_EQ(enclose({7, 0x1p-60}, kDoubleDoubleError), (Interval{7, above}));
  EXPECT_EQ(enclose({7, -0x1p-60}, kDoubleDoubleError), (Interval{below, 7}));
  EXPECT_EQ(enclose(DoubleDouble(7), kDoubleDoubleError), (Interval{below, above}));
  EXPECT_EQ(enclose({7, 0x1p-60}, 0x1p-50 * 0x1p-10), (Interval{below, above}));
  EXPECT_EQ(enclose(DoubleDouble(), kDoubleDoubleError), (Interval{0, 0}));
}

TEST(Enclose, CountsStepsAmongDenormals) {
  const double step = 0x1p-1074;
  EXPECT_EQ(enclose(DoubleDouble(100 * step), 10 * kDoubleDoubleError), (Interval{89 * step, 111 * step}));
  EXPECT_EQ(enclose(DoubleDouble(5 * step), 10 * kDoubleDoubleError), (Interval{0, 16 * step}));
}

}  // namespace
}  // namespace mwt
