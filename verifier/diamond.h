// Step 1 of a proof: the edges that the diamond test leaves, found without the proof's help.
#pragma once

#include "verifier/edge_set.h"
#include "verifier/point_tree.h"

namespace mwt::verifier {

/// The tangent of the diamond's base angle: the largest double below tan(pi / 4.6), so that the triangles are no larger
/// than those of the theorem.
inline constexpr double kDiamondTangent = 0x1.a08afb3b90ef8p-1;

/// All segments pq with no point in their interior and no point in the interior of at least one of the two isosceles
/// triangles over pq with this base angle. Exact.
///
/// Edges of minimum weight triangulations are among them: G. Das, D. Joseph 1989; R. L. Drysdale, S. McElfresh, J.
/// Snoeyink, "On exclusion regions for optimal triangulations", 2001.
[[nodiscard]] EdgeSet diamond_candidates(Points points, const PointTree& tree);

}  // namespace mwt::verifier
