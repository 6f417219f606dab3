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

/// Whether the segment uv is certainly farther from c than the square root of `squared`. Rounded towards no.
[[nodiscard]] inline bool is_surely_farther(const Point& c, const Point& u, const Point& v, double squared) {
  constexpr double kMargin = 1 + 1e-12;
  const double ux = u.x - c.x, uy = u.y - c.y, vx = v.x - c.x, vy = v.y - c.y;
  const double wx = vx - ux, wy = vy - uy;
  if (ux * wx + uy * wy >= 0) return ux * ux + uy * uy > squared * kMargin;
  if (vx * wx + vy * wy <= 0) return vx * vx + vy * vy > squared * kMargin;
  const double left = ux * vy, right = uy * vx;
  const double area = std::abs(left - right) - 8e-16 * (std::abs(left) + std::abs(right));
  return area > 0 && area * area > squared * (wx * wx + wy * wy) * kMargin;
}

}  // namespace mwt
