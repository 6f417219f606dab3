// The candidates of points in convex position: there the diamond test and the LMT-skeleton would keep nearly all edges
// after looking at all triples.
#pragma once

#include "algorithms/exact/candidates/candidate_graph.h"

namespace mwt {

/// The diagonals of more points would take gigabytes, and triangulating the polygon minutes.
inline constexpr std::size_t kMaxConvexPolygon = 6000;

/// All diagonals of the polygon `hull`, which goes counter-clockwise through all points, collinear runs allowed; only
/// the hull's edges are certain. O(n^2) time and space. Throws SearchStopped (search_stopped.h) if the hull has more
/// than kMaxConvexPolygon points.
[[nodiscard]] CandidateGraph convex_position_candidates(Points points, std::span<const Index> hull);

}  // namespace mwt
