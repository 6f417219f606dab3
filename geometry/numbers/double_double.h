// Unevaluated sums of two doubles (about 106 bits) and Euclidean lengths in them.
//
// Error bounds are relative and hold for the non-negative numbers that lengths are: each operation below errs by at
// most 2^-100 of its result (the textbook bounds are 2^-102 and better; see Joldes, Muller, Popescu, "Tight and
// rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 2017). Products also err by
// 2^-1074 where their low halves underflow: for results above 2^-970 that is within the bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/numbers/interval.h"
#include "geometry/point.h"

namespace mwt {

struct DoubleDouble {
  double high = 0;  ///< the value rounded to double
  double low = 0;   ///< the rest, at most half a unit in the last place of high

  DoubleDouble() = default;
  DoubleDouble(double value) : high(value) {}  // NOLINT(google-explicit-constructor): a double is one exactly
  DoubleDouble(double h, double l) : high(h), low(l) {}
};

/// Relative error bound of one operation on non-negative numbers.
inline constexpr double kDoubleDoubleError = 0x1p-100;

/// Sums of the high parts of two double-doubles that differ by more than this share of themselves are in the order of
/// the exact sums: each high part errs by 2^-53 of itself (the errors of the double-doubles are nothing to that), and
/// so does their sum, so that 4.1 * 2^-53 would do.
inline constexpr double kRoundedSumMargin = 0x1p-50;

/// a + b exactly.
[[nodiscard]] inline DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a + b exactly, provided |a| >= |b|.
[[nodiscard]] inline DoubleDouble exact_sum_ordered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a * b exactly, unless the product's last bits underflow.
[[nodiscard]] inline DoubleDouble exact_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

[[nodiscard]] inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  DoubleDouble sum = exact_sum(a.high, b.high);
  const DoubleDouble rest = exact_sum(a.low, b.low);
  sum.low += rest.high;
  sum = exact_sum_ordered(sum.high, sum.low);
  sum.low += rest.low;
  return exact_sum_ordered(sum.high, sum.low);
}

[[nodiscard]] inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }
[[nodiscard]] inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + (-b); }
inline DoubleDouble& operator+=(DoubleDouble& a, const DoubleDouble& b) { return a = a + b; }

[[nodiscard]] inline bool operator==(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high == b.high && a.low == b.low;
}
[[nodiscard]] inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

/// a squared.
[[nodiscard]] inline DoubleDouble square(const DoubleDouble& a) {
  DoubleDouble product = exact_product(a.high, a.high);
  product.low += 2 * (a.high * a.low);
  return exact_sum_ordered(product.high, product.low);
}

/// Square root of a non-negative number.
[[nodiscard]] inline DoubleDouble square_root(const DoubleDouble& a) {
  if (a.high <= 0) return {};
  const double root = std::sqrt(a.high);
  const DoubleDouble root_squared = exact_product(root, root);
  const double rest = ((a.high - root_squared.high) - root_squared.low) + a.low;
  return exact_sum_ordered(root, rest / (2 * root));
}

/// The length of segment pq, relative error at most 8 * kDoubleDoubleError for all coordinates up to 2^1000 in
/// magnitude: differences are exact, and squares are scaled so that they neither overflow nor underflow. Lengths below
/// 2^-970 err by at most 2^-1074 besides, from scaling back.
[[nodiscard]] inline DoubleDouble length(const Point& p, const Point& q) {
  DoubleDouble dx = exact_sum(p.x, -q.x);
  DoubleDouble dy = exact_sum(p.y, -q.y);
  const double size = std::max(std::abs(dx.high), std::abs(dy.high));
  constexpr double kMaxSquarable = 0x1p400;  // squares within 2^-800 and 2^801: their low parts do not underflow
  const bool squares_are_safe = size > 1 / kMaxSquarable && size < kMaxSquarable;
  if (squares_are_safe) return square_root(square(dx) + square(dy));
  if (size == 0) return {};
  const int exponent = std::ilogb(size);
  const auto scaled = [&](const DoubleDouble& a, int e) {
    return DoubleDouble{std::scalbn(a.high, e), std::scalbn(a.low, e)};
  };
  return scaled(square_root(square(scaled(dx, -exponent)) + square(scaled(dy, -exponent))), exponent);
}

/// The doubles around `value`, whose relative error is at most `relative_error`: kDoubleDoubleError times the number of
/// operations, each length counted at least once. As lengths err by up to one step of 2^-1074 however small they are,
/// that number also bounds the steps. Precondition: relative_error <= 2^-54, so that the true value is no farther away
/// than the double next to value.high.
[[nodiscard]] inline Interval enclose(const DoubleDouble& value, double relative_error) {
  if (value.high == 0) return {};
  constexpr double kStep = std::numeric_limits<double>::denorm_min();
  constexpr double kMinSlackWithoutSteps = 0x1p-1000;  // 2^74 steps: a few more disappear in the sums below
  const double slack = std::abs(value.high) * relative_error + relative_error / kDoubleDoubleError * kStep;
  const bool steps_count = slack < kMinSlackWithoutSteps;
  if (steps_count) {
    const double reach = std::abs(value.low) + slack;
    const double lower = next_down(value.high - reach);
    return {value.high > 0 ? std::max(0.0, lower) : lower, next_up(value.high + reach)};
  }
  return {value.low - slack < 0 ? next_down(value.high) : value.high,
          value.low + slack > 0 ? next_up(value.high) : value.high};
}

}  // namespace mwt
