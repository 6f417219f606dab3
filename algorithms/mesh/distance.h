// Rounded distances, for sums and comparisons that allow for rounding or do not depend on it.
#pragma once

#include <cmath>

#include "geometry/point.h"

namespace mwt {

/// The distance of two points, relative error below 2^-50 for all coordinates up to 1e300: the plain formula where
/// squares stay in range, std::hypot elsewhere.
[[nodiscard]] inline double rounded_distance(const Point& p, const Point& q) {
  const double dx = p.x - q.x, dy = p.y - q.y;
  const double squared = dx * dx + dy * dy;
  const bool in_range = squared > 1e-280 && squared < 1e300;
  return in_range ? std::sqrt(squared) : std::hypot(dx, dy);
}

/// The squared distance by the plain formula: relative error below 4.5e-16 while it stays in the range of doubles.
[[nodiscard]] inline double rounded_squared_distance(const Point& p, const Point& q) {
  const double dx = p.x - q.x, dy = p.y - q.y;
  return dx * dx + dy * dy;
}

}  // namespace mwt
