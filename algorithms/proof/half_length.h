// Lengths as integers, for dual values.
#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/numbers/double_double.h"

namespace mwt {

/// Half of a length in units of 2^unit_exponent, rounded down: at most one unit too small, never too large.
/// Preconditions: the length errs by less than 2^-90 of itself, and the result is below 2^58.
[[nodiscard]] inline std::int64_t half_length(const DoubleDouble& length, int unit_exponent) {
  const double high = std::ldexp(length.high, -unit_exponent - 1), low = std::ldexp(length.low, -unit_exponent - 1);
  const double whole = std::floor(high);
  constexpr double kFarMoreThanTheError = 0x1p-20;
  return static_cast<std::int64_t>(whole) +
         static_cast<std::int64_t>(std::floor((high - whole) + (low - kFarMoreThanTheError)));
}

}  // namespace mwt
