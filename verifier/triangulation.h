// The hull, and what the proof gives as its triangulation.
#pragma once

#include <array>
#include <vector>

#include "geometry/point.h"
#include "verifier/bounds.h"

namespace mwt::verifier {

using Corners = std::array<Index, 3>;

/// All points on the boundary of the convex hull, counter-clockwise, those in the middle of its sides included; empty
/// if all points are collinear. Preconditions: distinct points, at least one. O(n log n).
[[nodiscard]] std::vector<Index> hull_of(Points points);

/// Throws Refused unless the triangles are a triangulation of all the points.
///
/// Checked: indices are below the number of points; every triangle turns left; no directed edge is a side of two
/// triangles; a side without a triangle on its other side is an edge of the hull, and every edge of the hull is one;
/// the triangles are 2 n - 2 - h. That suffices: the boundaries of the triangles add up to the hull, so the numbers of
/// triangles that cover a point of the plane are what the hull's winding number is, 1 inside and 0 outside. By Euler's
/// formula so many triangles need all n points as corners; a point inside a triangle or on its side would be covered by
/// its own triangles as well.
void check_triangulation(Points points, const std::vector<Index>& hull, const std::vector<Corners>& triangles);

/// The total length of the edges, each once. Precondition: the triangles are a triangulation.
[[nodiscard]] Bounds weight_of(Points points, const std::vector<Corners>& triangles, const std::vector<Index>& hull);

}  // namespace mwt::verifier
