// Simulated annealing over edge flips: the baseline that local searches are compared with.
#pragma once

#include <cstdint>

#include "algorithms/algorithm.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

struct AnnealingOptions {
  std::uint64_t proposals = 0;
  double initial_temperature = 0;  ///< in units of the coordinates
  double final_temperature = 0;    ///< 0 < final <= initial
  std::uint64_t seed = 1;
};

struct AnnealingResult {
  std::uint64_t accepted = 0;
  bool stopped_early = false;
};

/// Proposes flips of random edges and accepts each with probability min(1, exp(-(change of length) / temperature)) if
/// the quadrilateral is strictly convex; the temperature falls geometrically. O(1) per proposal. What it leaves is the
/// state at the end, not the best on the way. Obeys the deadline of `context`. Deterministic for a seed.
AnnealingResult anneal(PlanarMesh& mesh, const AnnealingOptions& options, const Context& context);

/// The entry anneals, then flips to a local optimum, and returns the start instead should that be shorter.
[[nodiscard]] AlgorithmInfo annealing_entry();

}  // namespace mwt
