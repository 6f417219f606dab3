#include "geometry/mesh/in_circle.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace mwt::detail {

namespace {

__extension__ using Wide = __int128;

constexpr int kGridBits = 30;
// Between these, kGridBits bits below the largest difference stay clear of denormal numbers, and nothing overflows.
constexpr double kMinDifference = 1e-250, kMaxDifference = 1e250;

// The differences to d as integers on a common grid, if they are exactly that. On success |values| <= 2^kGridBits.
bool on_a_grid(const Point& a, const Point& b, const Point& c, const Point& d, std::array<std::int64_t, 6>& values) {
  const std::array<double, 6> ends{a.x, a.y, b.x, b.y, c.x, c.y};
  std::array<double, 6> differences{};
  double largest = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const double origin = i % 2 == 0 ? d.x : d.y;
    differences[i] = ends[i] - origin;
    if (differences[i] + origin != ends[i] || ends[i] - differences[i] != origin) return false;
    largest = std::max(largest, std::abs(differences[i]));
  }
  if (!(largest > kMinDifference && largest < kMaxDifference)) return false;
  const int shift = kGridBits - 1 - std::ilogb(largest);
  for (std::size_t i = 0; i < 6; ++i) {
    const double scaled = std::scalbn(differences[i], shift);
    const bool has_vanished = scaled == 0 && differences[i] != 0;
    values[i] = static_cast<std::int64_t>(scaled);
    if (has_vanished || static_cast<double>(values[i]) != scaled) return false;
  }
  return true;
}

}  // namespace

int in_circle_slow(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<std::int64_t, 6> v{};
  if (!on_a_grid(a, b, c, d, v)) return in_circle(a, b, c, d);
  // Lifts and minors stay below 2^61, their products below 2^122.
  const Wide determinant = Wide{v[0] * v[0] + v[1] * v[1]} * Wide{v[2] * v[5] - v[3] * v[4]} +
                           Wide{v[2] * v[2] + v[3] * v[3]} * Wide{v[4] * v[1] - v[5] * v[0]} +
                           Wide{v[4] * v[4] + v[5] * v[5]} * Wide{v[0] * v[3] - v[1] * v[2]};
  return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

}  // namespace mwt::detail
