#include "algorithms/mesh/edge_order.h"

#include <algorithm>
#include <array>

#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr double kSmallestTrusted = 1e-250;
constexpr double kLargestTrusted = 1e290;

struct Differences {
  DoubleDouble x, y;  // exact
};

Differences differences(const Point& p, const Point& q) { return {exact_sum(p.x, -q.x), exact_sum(p.y, -q.y)}; }

// Sorted magnitudes of the two differences: equal ones span segments of equal length.
std::array<DoubleDouble, 2> shape(const Point& p, const Point& q) {
  auto [x, y] = differences(p, q);
  if (x.high < 0) x = -x;
  if (y.high < 0) y = -y;
  return x < y ? std::array{x, y} : std::array{y, x};
}

// -1, 0, +1 as the first edge is shorter, equal or longer.
int compare_lengths(const EdgeKey& one, const EdgeKey& two, Points points) {
  const DoubleDouble& a = one.squared_length;
  const DoubleDouble& b = two.squared_length;
  const double sum = a.high + b.high;
  if (sum > kSmallestTrusted && sum < kLargestTrusted) {
    if (one.exact && two.exact) return a < b ? -1 : b < a ? 1 : 0;
    const DoubleDouble difference = a - b;
    if (std::abs(difference.high) > 0x1p-95 * sum) return difference.high < 0 ? -1 : 1;
  }
  const Point &p = points[one.low], &q = points[one.high], &r = points[two.low], &s = points[two.high];
  if (shape(p, q) == shape(r, s)) return 0;
  return detail::compare_length_exact(p, q, r, s);
}

}  // namespace

EdgeKey edge_key(Points points, Index a, Index b) {
  const auto [x, y] = differences(points[a], points[b]);
  EdgeKey key;
  key.low = std::min(a, b);
  key.high = std::max(a, b);
  const DoubleDouble xx = square(x), yy = square(y);
  key.squared_length = xx + yy;
  // Squares that fit one double, added without error.
  const bool in_range = key.squared_length.high > kSmallestTrusted && key.squared_length.high < kLargestTrusted;
  const auto no_underflow = [](const DoubleDouble& part, const DoubleDouble& part_squared) {
    return part.high == 0 || part_squared.high > kSmallestTrusted;
  };
  key.exact =
      in_range && x.low == 0 && y.low == 0 && xx.low == 0 && yy.low == 0 && no_underflow(x, xx) && no_underflow(y, yy);
  return key;
}

bool detail::precedes_slow(const EdgeKey& one, const EdgeKey& two, Points points) {
  const int sign = compare_lengths(one, two, points);
  if (sign != 0) return sign < 0;
  return one.low < two.low || (one.low == two.low && one.high < two.high);
}

}  // namespace mwt
