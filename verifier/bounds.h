// The verifier's real numbers: intervals of 136-bit floating-point numbers, rounded outwards by MPFI.
#pragma once

#include <boost/multiprecision/mpfi.hpp>
#include <cstdint>

#include "geometry/point.h"

namespace mwt::verifier {

/// Contains the true value. Every operation rounds its lower end down and its upper end up, and exponents are so large
/// that nothing underflows or overflows.
using Bounds =
    boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<40>, boost::multiprecision::et_off>;

[[nodiscard]] inline Bounds length(const Point& p, const Point& q) {
  const Bounds x = Bounds(p.x) - Bounds(q.x), y = Bounds(p.y) - Bounds(q.y);
  return sqrt(Bounds(x * x + y * y));
}

/// value * 2^exponent, exact.
[[nodiscard]] inline Bounds scaled(Bounds value, long exponent) {
  mpfi_mul_2si(value.backend().data(), value.backend().data(), exponent);
  return value;
}

/// The largest double not above the value, the smallest not below it.
[[nodiscard]] inline double lower_double(const Bounds& value) {
  return mpfr_get_d(&value.backend().data()[0].left, MPFR_RNDD);
}
[[nodiscard]] inline double upper_double(const Bounds& value) {
  return mpfr_get_d(&value.backend().data()[0].right, MPFR_RNDU);
}

/// The largest integer not above the value, or `limit` if that is smaller. Precondition: value >= 0.
[[nodiscard]] inline std::int64_t floor_below(const Bounds& value, std::int64_t limit) {
  const mpfr_srcptr lower = &value.backend().data()[0].left;
  return mpfr_cmp_si(lower, limit) >= 0 ? limit : static_cast<std::int64_t>(mpfr_get_si(lower, MPFR_RNDD));
}

}  // namespace mwt::verifier
