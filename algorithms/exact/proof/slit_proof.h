// Proofs for faces with two holes or isolated vertices: slit open in every way that matters, they have one.
#pragma once

#include <span>

#include "algorithms/deadline.h"
#include "algorithms/exact/holes/local_region.h"
#include "algorithms/proof_trace.h"

namespace mwt {

/// Fills the unit, the tree and the lower bound of a region whose boundary has three components and whose outline
/// (places, walks, open edges by points of `local`) is given. `known`: the diagonals of a triangulation that should be
/// optimal, a < b. Returns whether it did: not if there is a choice around the second hole that one leaf cannot decide
/// (strip_proof.h), if the tree would be too large or the deadline passes.
///
/// The tree decides the edges at an extreme point of one hole (HoleCuts), one after the other. With one of them in, the
/// region has one hole, and a leaf of strip_proof.h is to prove what is left of the known length. With all of them out,
/// nothing covers the place beyond the hole. Time and space: as many leaves as there are edges, each with all values.
[[nodiscard]] bool add_slit_duals(DualRegion& region, const LocalRegion& local, std::span<const Edge> known,
                                  const Deadline& deadline);

}  // namespace mwt
