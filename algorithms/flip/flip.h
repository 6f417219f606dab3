// Local search by edge flips: every quadrilateral gets its shorter diagonal until none can improve.
#pragma once

#include <vector>

#include "algorithms/algorithm.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Which of the possible flips is taken next.
enum class FlipOrder {
  stack,  ///< any; neighbours of the last one first
  best    ///< the one that gains most, gains compared in doubles (best_first.h)
};

struct FlipResult {
  std::size_t flips = 0;
  std::size_t tests = 0;  ///< looks at an edge that may have to be flipped
  bool stopped_early = false;
  std::vector<Flip> trace;  ///< the flips in order, if requested
};

/// Flips edges of `mesh` to shorter diagonals of strictly convex quadrilaterals until none is left: a local optimum
/// under exact comparison. Stops before at the deadline of `context`, with a valid triangulation.
///
/// Every flip shortens the triangulation, so this ends; equal diagonals are left alone. The greedy triangulation is a
/// fixed point: the shorter diagonal of a convex quadrilateral all of whose sides greedy chose was tried first. Time
/// O(n) plus O(1) per flip for `stack`, O(log n) for `best`; the number of flips is linear in practice, O(n^2) known.
/// Space O(n), for `best` 32 bytes per flip more. Deterministic.
FlipResult flip_to_local_optimum(PlanarMesh& mesh, FlipOrder order, const Context& context, bool with_trace = false);

/// Whether some flip would shorten the triangulation. Exact. O(n).
[[nodiscard]] bool is_flip_optimal(const PlanarMesh& mesh);

[[nodiscard]] AlgorithmInfo flip_entry();

}  // namespace mwt
