// Dual values under which a known cover has no slack, as a flow through the plane.
#pragma once

#include "algorithms/triangle_lp/cover_model.h"

namespace mwt {

/// Dual values under which every triangle of `cover` has reduced cost 0, and those of any other candidate add up to its
/// share, by area, of the costs of the triangles it overlaps: a first guess at the dual solution that follows the
/// density of the points.
///
/// Each triangle of the cover is a source of its own cost; the dual graph's shortest paths carry it to the boundary;
/// within a triangle the flow is the linear vector field with constant flow through each side (P. A. Raviart, J. M.
/// Thomas, "A mixed finite element method for second order elliptic problems", 1977). The dual value of a side is what
/// flows out through it.
///
/// All zero without a cover. In doubles: a starting point, so rounding does no harm. O(edges * triangles of the cover).
[[nodiscard]] CoverDuals duals_of_cover(const CoverModel& model, Points points, std::span<const Triangle> cover);

}  // namespace mwt
