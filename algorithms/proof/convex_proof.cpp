#include "algorithms/proof/convex_proof.h"

#include <new>

#include "algorithms/proof/polygon_duals.h"
#include "algorithms/proof_trace.h"
#include "geometry/weight.h"

namespace mwt {

void note_convex_polygon(Points points, std::span<const Index> hull, const std::optional<StopReason>& stop_reason,
                         const Context& context) {
  ProofTrace& trace = *context.proof;
  trace = trace_of_bound(cycle_length(points, hull).lower);
  if (stop_reason) return;
  if (auto region = duals_of_convex_polygon(points, hull, context)) {
    trace.lower_bound = next_down(trace.lower_bound + region->lower_bound);
    trace.regions.push_back(*std::move(region));
  }
}

std::optional<DualRegion> duals_of_convex_polygon(Points points, std::span<const Index> corners,
                                                  const Context& context) {
  const std::size_t diagonals = corners.size() * (corners.size() - 3) / 2;
  if (corners.size() < 3 || diagonals > kMaxNotedEdges || !context.fits(PolygonDuals::bytes_for(diagonals))) return {};
  try {
    return PolygonDuals().solve(points, corners, diagonals_of_convex_polygon(points, corners), context.deadline);
  } catch (const std::bad_alloc&) {
    return {};
  }
}

}  // namespace mwt
