// Where the certain edges leave faces with holes or isolated vertices.
#pragma once

#include <vector>

#include "algorithms/exact/candidates/candidate_graph.h"

namespace mwt {

/// The vertices of the faces whose boundary has more than one component, ascending; none if the certain edges connect
/// all points. Candidates that cross certain edges may add vertices of other faces. O(candidates), and the stars of the
/// vertices found.
[[nodiscard]] std::vector<Index> composite_vertices(const CandidateGraph& graph);

}  // namespace mwt
