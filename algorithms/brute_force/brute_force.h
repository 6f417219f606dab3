// The source report's exact algorithm: all triangulations, one after the other; keep the lightest.
#pragma once

#include <cstdint>

#include "algorithms/algorithm.h"

namespace mwt {

/// Sets of edges are 128 bits wide, which is enough for 16 points.
inline constexpr Index kBruteForceMaxN = 16;

struct BruteForceResult {
  Triangulation lightest;
  Interval optimum;  ///< certified weight of a minimum weight triangulation; its upper end is the weight of `lightest`
  std::uint64_t count = 0;  ///< triangulations seen
  bool complete = false;    ///< all of them were
};

/// Section 4 of the source report: (1) generate all triangulations, (2) weigh each, (3) select the lightest.
///
/// Each triangulation is generated exactly once: grow a triangulated region from the hull inwards; of all directed
/// edges that still lack the triangle on their left, take the first in a fixed order and try every triangle that fits
/// there. A triangulation has exactly one triangle at that place, so no two branches lead to the same one; and every
/// region left over can be triangulated, so no branch is in vain.
///
/// Preconditions: 3 to kBruteForceMaxN distinct points, not all collinear.
/// Ties: the first lightest triangulation found. Exact decisions; weights in double-double.
/// Time: O(n) per triangulation, of which there are exponentially many. Space O(n^3). Deterministic.
/// Past the deadline it stops after the triangulation at hand: `lightest` is the lightest so far, optimum.lower means
/// nothing.
[[nodiscard]] BruteForceResult enumerate_triangulations(Points points, const Context& context);

[[nodiscard]] AlgorithmInfo brute_force_entry();

}  // namespace mwt
