// Rounded distances, for sums and comparisons that allow for rounding or do not depend on it.
#pragma once

#include <cmath>

#include "geometry/mesh/margins.h"
#include "geometry/numbers/trusted_range.h"
#include "geometry/point.h"

namespace mwt {

/// The distance of two points for all coordinates up to 1e300, relative error below 2^-50 unless it is denormal: the
/// plain formula where squares stay in range, std::hypot elsewhere.
[[nodiscard]] inline double rounded_distance(const Point& p, const Point& q) {
  const double dx = p.x - q.x, dy = p.y - q.y;
  const double squared = dx * dx + dy * dy;
  return is_trusted_product(squared) ? std::sqrt(squared) : std::hypot(dx, dy);
}

/// The squared distance by the plain formula: relative error below 4.5e-16 where it is a trusted product
/// (geometry/numbers/trusted_range.h).
[[nodiscard]] inline double rounded_squared_distance(const Point& p, const Point& q) {
  const double dx = p.x - q.x, dy = p.y - q.y;
  return dx * dx + dy * dy;
}

/// Whether the segment uv is certainly farther from c than the square root of `squared`. Rounded towards no.
/// Precondition: `squared` is a trusted product.
///
/// Where u or v is nearest, an underflow of the scalar product may take for that what is a point of the segment at most
/// 2^-536 away, nothing to the margin at distances from 1e-140 on. Between them, the base of the triangle decides: the
/// answer is no if its square underflows.
[[nodiscard]] inline bool is_surely_farther(const Point& c, const Point& u, const Point& v, double squared) {
  constexpr double kMargin = 1 + kProductMargin;
  // Of the two products: each errs by 3 * 2^-53 of itself, their difference by 2^-53 more.
  constexpr double kDeterminantError = 8e-16;
  const double ux = u.x - c.x, uy = u.y - c.y, vx = v.x - c.x, vy = v.y - c.y;
  const double wx = vx - ux, wy = vy - uy;
  if (ux * wx + uy * wy >= 0) return ux * ux + uy * uy > squared * kMargin;
  if (vx * wx + vy * wy <= 0) return vx * vx + vy * vy > squared * kMargin;
  const double left = ux * vy, right = uy * vx;
  const double area = std::abs(left - right) - kDeterminantError * (std::abs(left) + std::abs(right));
  const double base = wx * wx + wy * wy, square_below = squared * base * kMargin;
  return area > 0 && area * area > square_below && is_trusted_product(base) && is_trusted_product(square_below);
}

}  // namespace mwt
