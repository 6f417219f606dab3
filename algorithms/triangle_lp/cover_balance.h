// Good dual values before any linear program is solved, by balancing the two sides of every edge.
#pragma once

#include "algorithms/deadline.h"
#include "algorithms/triangle_lp/cover_model.h"

namespace mwt {

/// Improves dual values until few triangles have a small reduced cost and few a negative one: usually to within a few
/// per cent of the best dual solution. Only a starting point, so rounding does no harm. All edges must be open.
///
/// Block-coordinate dual ascent: every inner edge moves dual value from one of its sides to the other until the least
/// reduced costs on both sides are equal; every boundary edge takes the least reduced cost of its triangles.
///
/// O(columns) per sweep over the edges, at most 20,000 sweeps and 10^9 columns. Deterministic, except for the deadline.
void balance_duals(const CoverModel& model, CoverDuals& duals, const Deadline& deadline);

}  // namespace mwt
