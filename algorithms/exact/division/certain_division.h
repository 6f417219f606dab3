// Divides what the certain edges leave in pieces: edges of the beta-skeleton become certain, and LMT goes on.
#pragma once

#include "algorithms/algorithm.h"
#include "algorithms/exact/candidates/candidate_graph.h"
#include "algorithms/exact/candidates/lmt_kernels.h"
#include "algorithms/exact/candidates/stars.h"

namespace mwt {

/// Whether the certain edges connect all points. Otherwise some face has holes or isolated vertices. O(candidates).
[[nodiscard]] bool is_connected(const CandidateGraph& graph);

/// Deletes from the stars the candidates of `graph`, which is the graph of these stars, that cross an edge of the
/// beta-skeleton (beta_skeleton.h), then the edges that have no certificate without them (lmt_kernels.h). No minimum
/// weight triangulation contains any of them. The edges of the beta-skeleton are crossed by no candidate afterwards, so
/// that mark_certain_edges() finds them. Returns how many crossed one.
///
/// On uniform points hardly anything would go, for the price of a Delaunay triangulation: meant for graphs that are not
/// connected. O(n log n) and a search per candidate. Runs on the threads of the enclosing task arena; the result does
/// not depend on them. Throws SearchStopped (search_stopped.h) after the context's deadline.
std::size_t delete_what_crosses_beta_skeleton(const CandidateGraph& graph, const HullEdges& hull, StarTable& stars,
                                              const Context& context);

}  // namespace mwt
