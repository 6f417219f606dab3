// Angles as complex numbers: sums of angles without trigonometry.
#pragma once

#include <cmath>

#include "geometry/point.h"

namespace mwt {

/// The complex number whose argument is an angle and whose modulus is the product of the sides that span it. Rounded:
/// errs by less than 1e-15 of its size(), as long as that is a trusted product (geometry/numbers/trusted_range.h).
struct Angle {
  double real = 0;
  double imaginary = 0;
};

/// The angle at `apex`, counter-clockwise from the direction of `from` to that of `to`.
[[nodiscard]] inline Angle angle_at(const Point& apex, const Point& from, const Point& to) {
  const double fx = from.x - apex.x, fy = from.y - apex.y, tx = to.x - apex.x, ty = to.y - apex.y;
  return {fx * tx + fy * ty, fx * ty - fy * tx};
}

/// The sum of two angles.
[[nodiscard]] inline Angle operator*(const Angle& a, const Angle& b) {
  return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
}

/// At least the modulus, at most sqrt 2 times it.
[[nodiscard]] inline double size(const Angle& a) { return std::abs(a.real) + std::abs(a.imaginary); }

}  // namespace mwt
