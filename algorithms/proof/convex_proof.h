// A proof of the optimum of points in convex position, for the verifier.
#pragma once

#include <optional>
#include <span>

#include "algorithms/algorithm.h"
#include "algorithms/proof_trace.h"
#include "geometry/point.h"

namespace mwt {

/// Replaces the context's proof, which must be there, by one for points in convex position; `hull` is their
/// counter-clockwise cycle. The hull is certain, and everything else one polygon with dual values (polygon_duals.h).
///
/// If something stopped the solver, or duals_of_convex_polygon() gives none, there are no dual values: then the proof
/// shows only that the hull belongs to the triangulation.
void note_convex_polygon(Points points, std::span<const Index> hull, const std::optional<StopReason>& stop_reason,
                         const Context& context);

/// Regions with more open edges than these are left out of proofs, which then prove less: dual values take the time of
/// a plain dynamic program, and the verifier's time as much again.
inline constexpr std::size_t kMaxNotedEdges = 4'000'000;

/// Dual values for a convex polygon; corners may lie in the middle of its sides. Nothing if it has more than
/// kMaxNotedEdges diagonals (more than 2,829 corners), if they need more memory than the context allows or the system
/// has, or if the deadline passes. O(n^3) time, O(n^2) space.
[[nodiscard]] std::optional<DualRegion> duals_of_convex_polygon(Points points, std::span<const Index> corners,
                                                                const Context& context);

}  // namespace mwt
