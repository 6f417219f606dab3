// The source report's "dynamic programming" method (section 5.2): the hull optimally, then the interior points one by
// one.
#pragma once

#include <cstdint>

#include "algorithms/algorithm.h"
#include "geometry/numbers/interval.h"

namespace mwt {

enum class InsertionOrder {
  index,   ///< as given
  random,  ///< a random permutation
  x,       ///< lexicographic, by x, then by y
};

struct HullInsertion {
  Triangulation triangulation;
  Index hull_size = 0;                    ///< points on the hull's boundary
  Interval hull_weight;                   ///< certified weight of the hull's triangulation, before any insertion
  std::size_t points_on_edges = 0;        ///< insertions that split two triangles
  std::size_t depth = 0;                  ///< the largest number of splits that led to one triangle
  std::optional<StopReason> stop_reason;  ///< why the hull's triangulation is not optimal, unless it is
};

/// Triangulates the convex hull by triangulate_convex_polygon() with the source report's cost, the sum of perimeters,
/// the cycle starting at the lexicographically smallest point; with too little time or memory the result is what that
/// returns. Then inserts every interior point in the given order: the triangle (a, b, c) that holds it is replaced in
/// place by (a, b, p), (b, c, p), (c, a, p). A point on an edge replaces the triangles on both sides, each in place,
/// leaving out the flat one of the three. The list is in the order that this gives.
///
/// `seed` matters for InsertionOrder::random only (Boost.Random: the same on every platform).
/// Points on the hull's sides belong to the hull. Preconditions: distinct points, not all collinear.
/// O(h^3 + n log^2 n) time for any points and order, O(h^2 + n) space. Deterministic.
[[nodiscard]] HullInsertion hull_insertion(Points points, InsertionOrder order, std::uint64_t seed, Context& context);

/// Registry entry. The deadline cuts short the hull's program only: with points left out there is no triangulation, and
/// inserting them takes less time than another triangulation would.
[[nodiscard]] AlgorithmInfo hull_insertion_entry();

}  // namespace mwt
