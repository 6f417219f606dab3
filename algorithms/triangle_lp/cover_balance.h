// Good credits before any linear program is solved, by balancing the two sides of every edge.
#pragma once

#include "algorithms/deadline.h"
#include "algorithms/triangle_lp/cover_model.h"

namespace mwt {

/// Improves credits until few triangles have a small reduced cost and few a negative one: usually to within a few per
/// cent of the best dual solution. Only a starting point, so rounding does no harm. All edges must be open.
///
/// Block-coordinate dual ascent: every inner edge moves credit from one of its sides to the other until the least
/// reduced costs on both sides are equal; every boundary edge takes what its triangle can still give.
///
/// O(columns) per sweep over the edges, at most 20,000 sweeps and 10^9 columns. Deterministic, except for the deadline.
void balance_credits(const CoverModel& model, CoverCredits& credits, const Deadline& deadline);

}  // namespace mwt
