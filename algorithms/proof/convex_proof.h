// A proof of the optimum of points in convex position, for the verifier.
#pragma once

#include <optional>
#include <span>

#include "algorithms/algorithm.h"
#include "geometry/point.h"

namespace mwt {

/// Replaces the context's proof, which must be there, by one for points in convex position; `hull` is their
/// counter-clockwise cycle. The hull is certain, and everything else one polygon with dual values (polygon_duals.h).
///
/// For hulls of more than kMaxNotedEdges diagonals (more than 2,829 points), or if something stopped the solver, there
/// are no dual values: then the proof shows only that the hull belongs to the triangulation. O(n^3) time, O(n^2) space.
void note_convex_polygon(Points points, std::span<const Index> hull, const std::optional<StopReason>& stop_reason,
                         const Context& context);

/// Regions with more open edges than these are left out of proofs, which then prove less: dual values take the time of
/// a plain dynamic program, and the verifier's time as much again.
inline constexpr std::size_t kMaxNotedEdges = 4'000'000;

/// Whether the diagonals of a convex polygon with so many corners are few enough.
[[nodiscard]] constexpr bool is_noted_polygon(std::size_t corners) {
  return corners > 2 && corners * (corners - 3) / 2 <= kMaxNotedEdges;
}

}  // namespace mwt
