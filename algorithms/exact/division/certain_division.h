// Divides what the certain edges leave in pieces: edges of the beta-skeleton become certain, and LMT goes on.
#pragma once

#include <span>

#include "algorithms/algorithm.h"
#include "algorithms/exact/candidates/candidate_graph.h"
#include "algorithms/exact/candidates/kd_order.h"
#include "algorithms/exact/candidates/lmt_kernels.h"
#include "algorithms/exact/candidates/stars.h"

namespace mwt {

/// Deletes from the stars the candidates of `graph`, which is the graph of these stars, that cross an edge of the
/// beta-skeleton between two of `vertices` (beta_skeleton.h), then the edges that have no certificate without them
/// (lmt_kernels.h). No minimum weight triangulation contains any of them. Candidates between other vertices are left
/// aside: `vertices`, ascending, are those of the faces to be divided (faces/composite_vertices.h). Hardly any
/// candidate that ends at them crosses one of those edges afterwards, so that mark_certain_edges() finds them.
/// Returns how many crossed one.
///
/// The points of `order` are the graph's. O(n), O(log n) for each of the vertices and for each of their candidates.
/// Runs on the threads of the enclosing task arena; the result does not depend on them. Throws SearchStopped
/// (search_stopped.h) after the context's deadline.
std::size_t delete_what_crosses_beta_skeleton(const KdOrder& order, std::span<const Index> vertices,
                                              const CandidateGraph& graph, const HullEdges& hull, StarTable& stars,
                                              const Context& context);

}  // namespace mwt
