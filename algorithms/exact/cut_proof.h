// Proofs for faces with one hole or isolated vertex: cut open in every way that matters, they are polygons.
#pragma once

#include "algorithms/deadline.h"
#include "algorithms/exact/holes/local_region.h"
#include "algorithms/proof_trace.h"

namespace mwt {

/// Fills the unit, the tree and the lower bound of a region whose boundary has two components and whose outline
/// (places, walks, open edges by points of `local`) is given. Returns whether it did: not if the tree would be too
/// large or the deadline passes.
///
/// Let u be the inner component's last point in some direction. A triangulation leaves no angle of 180 degrees at u, so
/// one of the open edges that lead from u farther in that direction is part of it (CutPolygon in holes/cut_polygon.h).
/// The tree decides them one after the other: if one is in, the region is a polygon, whose dynamic program gives dual
/// values (PolygonDuals). If all are out, no triangle covers the place beyond u, and the signs with which sides cross
/// the ray from there, multiplied by a large number, prove it: they add up to 1 around the region, to 0 around every
/// triangle.
///
/// Time and space: as many interval programs, and as many values per open edge, as there are such edges.
bool add_cut_duals(DualRegion& region, const LocalRegion& local, const Deadline& deadline);

}  // namespace mwt
