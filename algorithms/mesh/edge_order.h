// Greedy's order of edges: exact squared length, then smaller index, then larger index.
#pragma once

#include "geometry/double_double.h"
#include "geometry/point.h"

namespace mwt {

/// An edge with what it takes to place it in the order, nearly always without looking at its points again.
struct EdgeKey {
  DoubleDouble squared_length;  ///< relative error at most 2^-97 where trustworthy, see key_of()
  Index low = 0;                ///< the ends, low < high
  Index high = 0;
  bool exact = false;  ///< squared_length is exact
};

/// Whether the keys alone show that `one` is shorter; transitive.
[[nodiscard]] bool is_surely_shorter(const EdgeKey& one, const EdgeKey& two);

/// Whether two edges are known to be of equal length without further computation: by exact keys or congruent
/// differences of coordinates. False does not mean that they differ. An equivalence relation on edges of one kind.
[[nodiscard]] bool have_equal_lengths(const EdgeKey& one, const EdgeKey& two, Points points);

/// The key of edge ab. Outside [1e-250, 1e290] the squared length is only rough; the comparison then does not rely on
/// it.
[[nodiscard]] EdgeKey edge_key(Points points, Index a, Index b);

namespace detail {
bool precedes_slow(const EdgeKey& one, const EdgeKey& two, Points points);
}

/// Whether `one` comes before `two`: a strict total order on edges. Exact for arbitrary doubles.
[[nodiscard]] inline bool precedes(const EdgeKey& one, const EdgeKey& two, Points points) {
  const double a = one.squared_length.high, b = two.squared_length.high;
  // High parts err by 2^-52 of themselves at most.
  if (std::abs(a - b) > 1e-15 * (a + b) && a + b > 1e-250 && a + b < 1e290) return a < b;
  return detail::precedes_slow(one, two, points);
}

}  // namespace mwt
