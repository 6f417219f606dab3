// The plane's points and the index type by which everything else refers to them.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace mwt {

/// Position of a point in its instance. 32 bits: instances have fewer than 2^32 - 1 points.
using Index = std::uint32_t;
inline constexpr Index kNoIndex = std::numeric_limits<Index>::max();

/// A point with finite double coordinates.
struct Point {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point&, const Point&) = default;
};

using Points = std::span<const Point>;

/// Order of sweeps and monotone chains: by x, then by y.
[[nodiscard]] inline bool lexicographically_less(const Point& a, const Point& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// By y, then by x.
[[nodiscard]] inline bool colexicographically_less(const Point& a, const Point& b) {
  return a.y < b.y || (a.y == b.y && a.x < b.x);
}

/// Indices 0 .. points.size() - 1 in lexicographic order of their points; equal points by index. O(n log n).
[[nodiscard]] std::vector<Index> lexicographic_order(Points points);

}  // namespace mwt
