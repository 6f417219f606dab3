// What a region of a proof begins with: its boundary and its open edges.
#pragma once

#include "algorithms/exact/holes/local_region.h"
#include "algorithms/proof_trace.h"

namespace mwt {

/// Places by local numbers: closed walks along the boundary, in any order, then points that are on none; open edges by
/// places, ascending. Where the boundary meets itself, any way to go on makes closed walks in the end: there may be
/// more of them than the boundary has components. No unit, no tree.
[[nodiscard]] DualRegion outline_of(const LocalRegion& local);

}  // namespace mwt
