#include "algorithms/proof/convex_proof.h"

#include "algorithms/proof/polygon_duals.h"
#include "algorithms/proof_trace.h"
#include "geometry/weight.h"

namespace mwt {

void note_convex_polygon(Points points, std::span<const Index> hull, const std::optional<StopReason>& stop_reason,
                         const Context& context) {
  ProofTrace& trace = *context.proof;
  trace = trace_of_bound(cycle_length(points, hull).lower);
  if (stop_reason || !is_noted_polygon(hull.size())) return;
  trace.regions.push_back(PolygonDuals().solve(points, hull, diagonals_of_convex_polygon(points, hull)));
  trace.lower_bound = next_down(trace.lower_bound + trace.regions.back().lower_bound);
}

}  // namespace mwt
