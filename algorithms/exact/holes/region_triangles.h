// The triangles that a triangulation of a region may consist of.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "geometry/triangulation.h"

namespace mwt {

/// The counter-clockwise triangles whose three sides are among the directed edges `sides` and that hold no other point,
/// boundary included; each once, starting at its smallest index. Nothing if there are more than `limit` of them or the
/// deadline passes.
///
/// Precondition: distinct points in lexicographic order. A side with a point in its interior belongs to no triangle.
///
/// Emptiness in constant time per triangle, after D. Eppstein, M. Overmars, G. Rote, G. Woeginger, "Finding minimum
/// area k-gons", Discrete & Computational Geometry 7 (1992): the points under each edge are counted once, and those in
/// a triangle are a difference of three such counts. Exact. Time: for every side, the points between its ends in
/// lexicographic order and the sides at its second end; space O(sides) and the result.
[[nodiscard]] std::optional<std::vector<Triangle>> region_triangles(Points points, std::span<const Edge> sides,
                                                                    std::size_t limit, const Deadline& deadline);

}  // namespace mwt
