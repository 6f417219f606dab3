// Proofs for faces with one hole or isolated vertex: cut open in every way that matters, they are polygons.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "algorithms/deadline.h"
#include "algorithms/exact/holes/local_region.h"
#include "algorithms/proof_trace.h"

namespace mwt {

/// Fills the unit, the tree and the lower bound of a region whose boundary has two components and whose outline
/// (places, walks, open edges by points of `local`) is given. `known`: the diagonals of a triangulation that should be
/// optimal, a < b, from which the unit is chosen; without them it is coarser. Returns whether it did: not if the tree
/// would be too large or the deadline passes.
///
/// Chords of either boundary get the optimum of the polygon that they cut off (holes/strip.h, PolygonDuals, each
/// boundary repeated twice). Edges across are nodes, triangles between two of them arcs, a triangulation is a closed
/// path around the hole. Nearly always one leaf is enough: the edges across get potentials under which no arc costs
/// less than nothing if those that contain the point beyond the hole (HoleCuts) cost less by the optimum; the ray from
/// there, times the optimum, makes them that much dearer again. There are no potentials if paths that go around more
/// than once are cheaper (odd wheels); then the tree decides the edges of HoleCuts, one after the other.
///   - The base: edges across 0.
///   - If a cut is in, edges across get the costs of the cheapest paths of triangles from the cut to them, and the cut,
///     at its other side, of one around the hole. Only these values differ from the base.
///   - If all cuts are out, no triangle covers the place beyond u, and the ray from there, multiplied by a large
///   number,
///     proves it.
///
/// Time: the programs of both boundaries, and one step for each triangle across, several times or for each cut; space:
/// for each cut one value for each edge across.
bool add_strip_duals(DualRegion& region, const LocalRegion& local, std::span<const Edge> known,
                     const Deadline& deadline);

/// The same with one leaf and the unit of `region`, if the dual values can prove `target` units.
bool add_strip_leaf(DualRegion& region, const LocalRegion& local, std::int64_t target, const Deadline& deadline);

}  // namespace mwt
