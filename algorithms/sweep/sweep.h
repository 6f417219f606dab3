// The triangulation that a sweep from left to right leaves behind: the simplest start for a local search.
#pragma once

#include "algorithms/algorithm.h"

namespace mwt {

/// Adds the points in lexicographic order and joins each to all hull edges of the points before it that it sees
/// (strictly: an edge in line with it is not seen). The first point off the line of an initial collinear run is joined
/// to the whole run.
///
/// Triangles are listed as they arise: by their last point, around it counter-clockwise from the lexicographically last
/// point before it, then clockwise; each is (u, v, p), counter-clockwise. Exact predicates only. Deterministic.
/// Precondition: distinct points, not all collinear. O(n log n) time, O(n) space.
[[nodiscard]] Triangulation sweep_triangulation(Points points);

/// Registry entry: the raw sweep, about sqrt(n) times too heavy on random points. No parameters, no deadline.
[[nodiscard]] AlgorithmInfo sweep_entry();

}  // namespace mwt
