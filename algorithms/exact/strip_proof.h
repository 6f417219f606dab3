// Proofs for faces with one hole or isolated vertex: cut open in every way that matters, they are polygons.
#pragma once

#include <cstddef>
#include <optional>

#include "algorithms/deadline.h"
#include "algorithms/exact/holes/local_region.h"
#include "algorithms/proof_trace.h"

namespace mwt {

/// Fills the unit, the tree and the lower bound of a region whose boundary has two components and whose outline
/// (places, walks, open edges by points of `local`) is given. `length` is that of an optimal triangulation's diagonals,
/// for which the unit is chosen; without it the unit is coarser. Returns whether it did: not if the tree would be too
/// large or the deadline passes.
///
/// Let u be the inner component's last point in some direction. A triangulation leaves no angle of 180 degrees at u, so
/// one of the open edges that lead from u farther in that direction is part of it (CutPolygon in holes/cut_polygon.h).
/// The tree decides these cuts one after the other.
///   - The base: chords of either boundary get the optimum of the polygon that they cut off (holes/strip.h,
///     PolygonDuals, each boundary repeated twice), edges across 0.
///   - If a cut is in, edges across get the costs of the cheapest paths of triangles from the cut to them, and the cut,
///     at its other side, of one around the hole. Only these values differ from the base.
///   - If all cuts are out, no triangle covers the place beyond u, and the signs with which sides cross the ray from
///     there, multiplied by a large number, prove it: they add up to 1 around the region, to 0 around every triangle.
///
/// Time: the programs of both boundaries, and for each cut one step for each triangle across; space: for each cut one
/// value for each edge across.
bool add_strip_duals(DualRegion& region, const LocalRegion& local, std::optional<double> length,
                     const Deadline& deadline);

}  // namespace mwt
