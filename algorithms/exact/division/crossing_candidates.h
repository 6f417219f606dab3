// Finds candidates that leave the faces of the certain edges.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/candidates/candidate_graph.h"
#include "geometry/triangulation.h"

namespace mwt {

/// Those of the candidates `suspects` that cross a certain edge or pass through a point, in their order. No minimum
/// weight triangulation contains such an edge. The LMT stage leaves some where its floats are uncertain, or where a
/// point inside a certificate's triangle is a neighbour of neither end: hardly ever on random input, often where
/// coordinates mix scales.
///
/// Exact. A search for each candidate in a tree of boxes over the points in their order: O(log n) for short ones if
/// neighbours in the order are neighbours in the plane. Runs on the threads of the enclosing task arena; the result
/// does not depend on them. Nothing if the deadline passes. For each edge of the result one certain edge that it
/// crosses is appended to `crossed`, if there is one: a == b if it passes through that point instead.
[[nodiscard]] std::optional<std::vector<Edge>> find_crossing_candidates(const CandidateGraph& graph,
                                                                        std::span<const Edge> suspects,
                                                                        const Deadline& deadline = {},
                                                                        std::vector<Edge>* crossed = nullptr);

/// Deletes `edges`, which are in the graph. O(graph) moves of memory and the stars of their ends.
void remove_edges(CandidateGraph& graph, std::span<const Edge> edges);

}  // namespace mwt
