// The candidates of points in convex position: there the diamond test and the LMT-skeleton would keep nearly all edges
// after looking at all triples.
#pragma once

#include "algorithms/exact/candidate_graph.h"

namespace mwt {

/// All diagonals of the polygon `hull`, which goes counter-clockwise through all points, collinear runs allowed; only
/// the hull's edges are certain. O(n^2) time and space.
[[nodiscard]] CandidateGraph convex_position_candidates(Points points, std::span<const Index> hull);

}  // namespace mwt
