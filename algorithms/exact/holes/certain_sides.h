// Which sides of the triangles that a region may consist of are in every triangulation of it.
#pragma once

#include <span>

#include "algorithms/exact/candidates/candidate_graph.h"

namespace mwt {

/// The graph of the sides of `triangles` and the region's `boundary` (directed, the region on the left). Certain are
/// the boundary and each edge that at one of its ends no triangle straddles: a triangulation without the edge would
/// have a triangle there that contains the edge's first piece.
///
/// Preconditions: counter-clockwise triangles without further points; every triangulation in question consists of them.
/// Triangles beside the region do no harm, but neither do they count as inside: see find_crossing_candidates() for
/// the sides that cross a certain edge. The points must stay alive. Exact. O(triangles log triangles + the sum over the
/// triangles of the edges inside their angles).
[[nodiscard]] CandidateGraph graph_of_sides(Points points, std::span<const Triangle> triangles,
                                            std::span<const Edge> boundary);

}  // namespace mwt
