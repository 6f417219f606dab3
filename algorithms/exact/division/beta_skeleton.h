// Edges that are in every minimum weight triangulation because no point sees them at a wide angle.
#pragma once

#include <span>
#include <vector>

#include "algorithms/exact/candidates/kd_order.h"
#include "geometry/triangulation.h"

namespace mwt {

/// The beta-skeleton for beta = 1.17682, ascending: S.-W. Cheng, Y.-F. Xu, "On beta-skeleton as a subgraph of the
/// minimum weight triangulation", Theoretical Computer Science 262 (2001). Every minimum weight triangulation contains
/// its edges. An edge is left out where rounding leaves a doubt (algorithms/common/beta_skeleton_edges.h), and on the
/// hull. Preconditions: distinct points, not all collinear. O(n log n).
[[nodiscard]] std::vector<Edge> beta_skeleton(Points points);

/// The edges of the beta-skeleton of all points of `order` that join two of `vertices` and are not on the hull of
/// these, left out in doubt as above. `vertices` ascend and are not all collinear. O(log n) for each of them where no
/// edge is much longer than the distances between points around it. Runs on the threads of the enclosing task arena;
/// the result does not depend on them.
[[nodiscard]] std::vector<Edge> beta_skeleton_between(const KdOrder& order, std::span<const Index> vertices);

}  // namespace mwt
