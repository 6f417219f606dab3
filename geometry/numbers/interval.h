// Certified real numbers: a pair of doubles between which the true value lies.
#pragma once

#include <cmath>
#include <limits>

namespace mwt {

/// The smallest double above x, the largest below x: one step outwards makes any correctly rounded result a bound.
[[nodiscard]] inline double next_up(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
[[nodiscard]] inline double next_down(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

/// An optimum counts as proved when its bounds are this close, relatively: far above the rounding of certified sums of
/// lengths (2.3e-16, weight.h) and of linear programs' bounds (1e-14), far below any gap between different optima that
/// could matter to alpha.
inline constexpr double kProvedRelativeWidth = 1e-12;

/// Invariant: lower <= true value <= upper.
struct Interval {
  double lower = 0;
  double upper = 0;

  [[nodiscard]] double width() const { return upper - lower; }
  [[nodiscard]] double middle() const { return lower + 0.5 * (upper - lower); }
  [[nodiscard]] bool contains(double x) const { return lower <= x && x <= upper; }

  /// Width over the upper end; 0 for a single value.
  [[nodiscard]] double relative_width() const { return upper == lower ? 0 : (upper - lower) / std::abs(upper); }

  friend bool operator==(const Interval&, const Interval&) = default;
};

[[nodiscard]] inline bool overlap(const Interval& a, const Interval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

/// Outward-rounded sum and difference.
[[nodiscard]] inline Interval operator+(const Interval& a, const Interval& b) {
  return {next_down(a.lower + b.lower), next_up(a.upper + b.upper)};
}
[[nodiscard]] inline Interval operator-(const Interval& a, const Interval& b) {
  return {next_down(a.lower - b.upper), next_up(a.upper - b.lower)};
}

}  // namespace mwt
