// Edges that are in every minimum weight triangulation because no point sees them at a wide angle.
#pragma once

#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// The beta-skeleton for beta = 1.17682, ascending: S.-W. Cheng, Y.-F. Xu, "On beta-skeleton as a subgraph of the
/// minimum weight triangulation", Theoretical Computer Science 262 (2001). Every minimum weight triangulation contains
/// its edges. An edge is left out where rounding leaves a doubt (algorithms/common/beta_skeleton_edges.h), and on the
/// hull. Preconditions: distinct points, not all collinear. O(n log n).
[[nodiscard]] std::vector<Edge> beta_skeleton(Points points);

}  // namespace mwt
