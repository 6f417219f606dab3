// Edges that belong to the greedy triangulation whatever comes later: found in any order, without a queue.
#pragma once

#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Whether the angles g and d opposite edge e in its two triangles certainly satisfy 2 max(g, d) + min(g, d) < 180
/// degrees. In a Delaunay triangulation constrained by greedy edges such an edge is shorter than every segment between
/// two points that crosses it and no constraint (lemma 2 in README.md), hence greedy under any tie rule.
///
/// Rounded towards no: floating point with a margin of 1e-12, a thousand times its error; angles whose products leave
/// the trusted range (geometry/numbers/trusted_range.h) get no. Precondition: e is not a hull edge.
[[nodiscard]] bool is_certainly_greedy(const PlanarMesh& mesh, MeshEdge e);

}  // namespace mwt
