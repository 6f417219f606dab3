// Which candidates of a graph are certain because no other one crosses them.
#pragma once

#include <cstddef>

#include "algorithms/exact/candidates/candidate_graph.h"

namespace mwt {

/// Marks candidates as certain that are in every triangulation by candidates of the graph that contains all of its
/// certain edges, and returns how many edges it has marked.
///
/// An edge st is marked if no edge yw between neighbours y, w of s crosses it: were st missing, it would enter a
/// triangle syw at s and leave it through yw. Exact. For each edge st and neighbour y, until a crossing is found, a
/// bisection for the edges of y between its directions to s and t.
std::size_t mark_uncrossed_edges(CandidateGraph& graph);

}  // namespace mwt
