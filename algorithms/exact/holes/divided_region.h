// A region that certain edges divide: its parts, one by one.
#pragma once

#include <optional>
#include <span>

#include "algorithms/exact/candidates/candidate_graph.h"
#include "algorithms/exact/holes/region_solver.h"

namespace mwt {

/// The lightest triangulation of a region by the candidates of `graph` that contains all of the graph's certain edges,
/// among them the region's `boundary` (directed, the region on the left; vertices of the graph). Polygons are solved by
/// their program, other parts by solve_region().
///
/// Nothing if the certain edges do not divide the region, or the deadline passes at once. Candidates may cross certain
/// edges: they are deleted.
[[nodiscard]] std::optional<RegionSolution> solve_divided_region(CandidateGraph graph, std::span<const Edge> boundary,
                                                                 const RegionSearch& search);

}  // namespace mwt
