// Dual values of the linear programs over a region's empty triangles, in integers: the verifier checks them.
#pragma once

#include <span>

#include "algorithms/proof_trace.h"
#include "algorithms/triangle_lp/triangle_cover.h"

namespace mwt {

/// Fills the unit, the tree of decisions with its dual values and the lower bound of a region whose outline (places,
/// walks, open edges) is given. `problem` is the region by the same indices: all its empty triangles, its boundary, and
/// as `start` a triangulation of it that should be optimal; without one there is no branching.
///
/// Linear programs with branching, as in triangle_cover.h, until the bound is within 1e-13 of the start, relatively, or
/// the deadline or numerical trouble ends the search; the bound holds in any case. Rounding the dual values costs at
/// most a few units in 2^56 per triangle, and is part of the bound.
void add_cover_duals(DualRegion& region, const TriangleCoverProblem& problem);

}  // namespace mwt
