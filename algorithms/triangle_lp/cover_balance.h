// Good credits before any linear program is solved, by balancing the two sides of every edge.
#pragma once

#include "algorithms/triangle_lp/cover_model.h"

namespace mwt {

/// Credits under which few triangles have a small reduced cost and few a negative one: usually within a few per cent of
/// the best dual solution. Only a starting point, so rounding does no harm.
///
/// Block-coordinate dual ascent: every inner edge moves credit from one of its sides to the other until the least
/// reduced costs on both sides are equal; every boundary edge takes what its triangle can still give. It begins with
/// `cover_cost`, the cost of a known cover or 0, spread over the triangles in proportion to their areas, so that little
/// is left to travel from the boundary inwards.
///
/// O(columns) per sweep over the edges, a thousand sweeps at most. Deterministic, except for the deadline.
[[nodiscard]] CoverCredits balanced_credits(const CoverModel& model, const TriangleCoverProblem& problem,
                                            double cover_cost);

}  // namespace mwt
