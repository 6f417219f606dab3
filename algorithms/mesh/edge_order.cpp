#include "algorithms/mesh/edge_order.h"

#include <algorithm>
#include <array>
#include <limits>

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

bool is_trusted(double squared_length) { return squared_length > kSmallestTrusted && squared_length < kLargestTrusted; }

// -1, 0, +1 as the first edge is shorter, equal or longer.
int compare_lengths(const EdgeKey& one, const EdgeKey& two, Points points) {
  if (is_surely_shorter(one, two)) return -1;
  if (is_surely_shorter(two, one)) return 1;
  if (have_equal_lengths(one, two, points)) return 0;
  return detail::compare_length_exact(points[one.low], points[one.high], points[two.low], points[two.high]);
}

}  // namespace

bool is_surely_shorter(const EdgeKey& one, const EdgeKey& two) {
  const DoubleDouble& a = one.squared_length;
  const DoubleDouble& b = two.squared_length;
  if (!is_trusted(a.high) || !is_trusted(b.high)) return false;
  if (one.exact && two.exact) return a < b;
  return (a - b).high < -0x1p-95 * (a.high + b.high);
}

bool have_equal_lengths(const EdgeKey& one, const EdgeKey& two, Points points) {
  if (one.exact && two.exact) return one.squared_length == two.squared_length;
  return shape(points[one.low], points[one.high]) == shape(points[two.low], points[two.high]);
}

EdgeKey edge_key(Points points, Index a, Index b) {
  const auto [x, y] = differences(points[a], points[b]);
  EdgeKey key;
  key.low = std::min(a, b);
  key.high = std::max(a, b);
  const DoubleDouble xx = square(x), yy = square(y);
  key.squared_length = xx + yy;
  const bool overflowed = !(key.squared_length.high < std::numeric_limits<double>::max());
  if (overflowed) key.squared_length = std::numeric_limits<double>::infinity();  // not the NaN of inf - inf
  // Squares that fit one double, added without error.
  const auto no_underflow = [](const DoubleDouble& part, const DoubleDouble& part_squared) {
    return part.high == 0 || part_squared.high > kSmallestTrusted;
  };
  key.exact = is_trusted(key.squared_length.high) && x.low == 0 && y.low == 0 && xx.low == 0 && yy.low == 0 &&
              no_underflow(x, xx) && no_underflow(y, yy);
  return key;
}

bool detail::precedes_slow(const EdgeKey& one, const EdgeKey& two, Points points) {
  const int sign = compare_lengths(one, two, points);
  if (sign != 0) return sign < 0;
  return one.low < two.low || (one.low == two.low && one.high < two.high);
}

}  // namespace mwt
