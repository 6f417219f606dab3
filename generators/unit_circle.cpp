#include "generators/unit_circle.h"

#include <utility>

#include "geometry/numbers/double_double.h"

namespace mwt {

namespace {

// pi / 4 to 106 bits.
const DoubleDouble kOctant{0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};

DoubleDouble product(const DoubleDouble& a, const DoubleDouble& b) {
  DoubleDouble result = exact_product(a.high, b.high);
  result.low += a.high * b.low + a.low * b.high;
  return exact_sum_ordered(result.high, result.low);
}

// numerator / denominator, both exact in doubles.
DoubleDouble quotient(double numerator, double denominator) {
  const double high = numerator / denominator;
  const double rest = std::fma(-high, denominator, numerator);  // exact
  return exact_sum_ordered(high, rest / denominator);
}

DoubleDouble divided(const DoubleDouble& a, double divisor) {
  const double high = a.high / divisor;
  const double rest = std::fma(-high, divisor, a.high) + a.low;
  return exact_sum_ordered(high, rest / divisor);
}

// first - first t^2 / ((k+1)(k+2)) + .., the Taylor series of cos (first = 1, k = 0) and sin (first = t, k = 1).
// For 0 <= t <= pi / 4 fourteen terms leave less than 2^-100. Summed from the smallest by Horner's rule.
double taylor_series(const DoubleDouble& first, const DoubleDouble& t_squared, int k) {
  constexpr int kTerms = 14;
  DoubleDouble sum = 1.0;
  for (int term = kTerms - 1; term > 0; --term) {
    const int degree = k + 2 * term;
    sum = DoubleDouble(1.0) - divided(product(sum, t_squared), degree * (degree - 1.0));
  }
  return product(first, sum).high;
}

}  // namespace

Point unit_circle_point(std::uint64_t numerator, std::uint64_t denominator) {
  const std::uint64_t octant = 8 * numerator / denominator;
  std::uint64_t part = 8 * numerator - octant * denominator;  // of an octant, over denominator
  if (octant % 2 == 1) part = denominator - part;             // odd octants are mirrored
  const DoubleDouble t = product(kOctant, quotient(static_cast<double>(part), static_cast<double>(denominator)));
  const DoubleDouble t_squared = product(t, t);
  double x = taylor_series(1.0, t_squared, 0);
  double y = taylor_series(t, t_squared, 1);
  // Octants 1, 2, 5, 6 lie nearer to the y axis; 2 .. 5 have x < 0, 4 .. 7 have y < 0. 0 - 0 is no -0.
  if ((octant + 1) / 2 % 2 == 1) std::swap(x, y);
  if (octant >= 2 && octant < 6) x = 0 - x;
  if (octant >= 4) y = 0 - y;
  return {x, y};
}

}  // namespace mwt
