// What proves the optimum of the region between two chains to somebody else.
#pragma once

#include <span>

#include "algorithms/proof_trace.h"
#include "geometry/point.h"

namespace mwt {

/// The region between the chains p and q, from bridge p.front() q.front() to bridge p.back() q.back(), with all edges
/// from chain to chain as open edges. Its dual values are potentials along the lattice paths of triangulate_corridor(),
/// in integers: an edge's side towards the first bridge gets what the triangles up to it cost at least, with half the
/// edge; the unit is chosen by the optimum, so that rounding loses less than 2^-54 of it per edge. O(|p| |q|) time and
/// space.
[[nodiscard]] DualRegion corridor_duals(Points points, std::span<const Index> p, std::span<const Index> q);

}  // namespace mwt
