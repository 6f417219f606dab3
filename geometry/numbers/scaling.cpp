#include "geometry/numbers/scaling.h"

#include <algorithm>
#include <cmath>

namespace mwt {

namespace {

// Coordinates between 1 / kModerate and kModerate need no scaling: their products are far from over- and underflow.
constexpr double kModerate = 0x1p100;

bool survives(double x, int e) { return std::scalbn(std::scalbn(x, -e), e) == x; }

}  // namespace

int exact_scale(Points points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const bool is_moderate = largest >= 1 / kModerate && largest <= kModerate;
  if (is_moderate || largest == 0) return 0;
  const int e = std::ilogb(largest);
  const bool is_exact =
      std::all_of(points.begin(), points.end(), [&](const Point& p) { return survives(p.x, e) && survives(p.y, e); });
  return is_exact ? e : 0;
}

Point scaled_down(const Point& p, int e) { return {std::scalbn(p.x, -e), std::scalbn(p.y, -e)}; }

Interval scaled_up(const Interval& bounds, int e) {
  const double lower = std::scalbn(bounds.lower, e), upper = std::scalbn(bounds.upper, e);
  return {std::scalbn(lower, -e) == bounds.lower ? lower : next_down(lower),
          std::scalbn(upper, -e) == bounds.upper ? upper : next_up(upper)};
}

std::vector<Point> exactly_scaled(Points points) {
  std::vector<Point> result(points.begin(), points.end());
  if (const int e = exact_scale(points); e != 0) {
    for (Point& p : result) p = scaled_down(p, e);
  }
  return result;
}

}  // namespace mwt
