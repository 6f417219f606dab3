// From the edges of a triangulation to its triangles.
#pragma once

#include <span>

#include "geometry/point.h"
#include "geometry/triangulation.h"

namespace mwt {

/// The bounded faces with three sides of the plane graph with these edges, counter-clockwise. If the edges are all
/// edges of a triangulation, these are its triangles; what other edges give is no triangulation, which the checker
/// finds (geometry/checker.h). Equal edges count once. Precondition: corners are positions in `points`, no edge ends
/// where it begins. O(m log m) for m edges.
[[nodiscard]] Triangulation triangulation_of(Points points, std::span<const Edge> edges);

}  // namespace mwt
