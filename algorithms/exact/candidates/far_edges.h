// Between the second and the third stage of the exact solver: repeats the diamond test for very long edges.
#pragma once

#include <cstddef>

#include "algorithms/exact/candidates/stars.h"

namespace mwt {

/// Deletes edges that reach from dense surroundings to a point more than 100 times as far away as the nearest
/// neighbour, and whose two diamond triangles certainly hold points of these surroundings. The diamond test itself
/// works with single precision relative to the edge's length, so that for it such surroundings lie on the edge's line;
/// here their own vectors, relatively precise, are compared with the edge by angle, nearly equal angles exactly. Edges
/// like these cross sides of faces that would otherwise be certain, and tie together what falls apart into polygons.
///
/// Returns the number of edges deleted. O(number of edges) time. Deterministic.
std::size_t delete_far_edges(Points points, StarTable& stars);

}  // namespace mwt
