// Proofs for faces with holes whose lightest triangulation has no choice about how to cut them open.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/holes/local_region.h"
#include "algorithms/proof_trace.h"

namespace mwt {

/// Fills the unit, the tree (one leaf) and the lower bound of a region whose boundary has `components`, several, and
/// whose outline (places, walks, open edges by points of `local`) is given. `known`: the diagonals of a triangulation
/// that should be optimal, a < b; they cut the region open. Returns whether there is a bound worth having.
///
/// The dual values are those of holes/cut_duals.h in integers, all triangles kept:
///   - chords of the cut-open polygon get what its program says (PolygonDuals), so that no triangle of chords costs
///     less than nothing;
///   - edges that cross cuts pass dual value from side to side until no triangle with such a side does;
///   - what cuts cost is charged to the triangles that contain a cut's first piece, at both ends. A point beside that
///     piece lies in one of these triangles or in the one on the cut's left. The sides of a triangle that holds a point
///     cross a ray from it once more outwards than inwards, those of others as often one way as the other: dual values
///     by these signs, times the charge, raise the bound by the charge and lower the costs of just these triangles.
/// If the triangulation is optimal and every triangle that crosses cuts is dear enough, the bound is its length.
///
/// Time: that of the polygon's program, and for each charge one step per edge.
[[nodiscard]] bool add_cut_duals(DualRegion& region, const LocalRegion& local, std::size_t components,
                                 std::span<const Edge> known, const Deadline& deadline);

}  // namespace mwt
