// The greedy order of edges: by exact length, ties by smaller end, then by larger end.
#pragma once

#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// Sorts `edges` (a < b in each) by length, then a, then b. A total order, so equal sets of edges give equal sequences.
///
/// Exact for all doubles: rounded squared lengths sort first, then every run of neighbours that rounding may have
/// confused is sorted by exact comparison. Squared lengths that are doubles themselves (integer points) count as exact,
/// so that the many ties of grids stay cheap; where squares overflow or underflow, every comparison is an exact one.
/// Precondition: indices in range. O(m log m) time, 16 bytes per edge of extra space.
void sort_by_length(Points points, std::vector<Edge>& edges);

}  // namespace mwt
