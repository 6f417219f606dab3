// Regions with holes, when all else leaves them open: one candidate after the other joins a hole to the rest.
#pragma once

#include <vector>

#include "algorithms/exact/holes/region_solver.h"

namespace mwt {

/// Candidates of which every triangulation of the region by candidates contains at least one, from a hole or isolated
/// vertex to another component; a < b. Empty if there is no triangulation.
///
/// The last point u of a hole's boundary in lexicographic order has all its boundary edges on one side. A triangulation
/// leaves no angle of 180 degrees there, so some edge leads to a later point, which is none of its component. The same
/// holds for the first point, and with x and y exchanged: the fewest edges of all are taken. Precondition: at least 2
/// components.
[[nodiscard]] std::vector<Edge> unavoidable_candidates(Points points, const FaceRegion& region);

/// Solves the region once with each of these, the shortest first, without those before it: each has a component less.
/// What the deadline leaves over keeps the simple bound.
[[nodiscard]] RegionSolution solve_by_branching(Points points, const FaceRegion& region, const RegionSearch& search);

}  // namespace mwt
