// Edges that belong to the greedy triangulation whatever comes later: found in any order, without a queue.
#pragma once

#include "algorithms/greedy/wedge.h"
#include "algorithms/mesh/edge_order.h"
#include "algorithms/mesh/planar_mesh.h"

namespace mwt {

/// Whether the angles g and d opposite edge e in its two triangles certainly satisfy 2 max(g, d) + min(g, d) < 180
/// degrees. In a Delaunay triangulation constrained by greedy edges such an edge is shorter than every segment between
/// two points that crosses it and no constraint (lemma 2 in README.md), hence greedy under any tie rule.
///
/// Rounded towards no: floating point with a margin of 1e-12, a thousand times its error; extreme coordinates, where
/// products of six differences leave the range of doubles, get no. Precondition: e is not a hull edge.
[[nodiscard]] bool is_certainly_greedy(const PlanarMesh& mesh, MeshEdge e);

/// Whether the wedge's third side ab is certainly greedy: the angle at its apex c is convex and not acute, the closed
/// triangle abc holds no other point, and ab precedes every edge from c through ab to a point visible from c. Only such
/// edges cross ab without crossing a fixed edge (lemma 3 in README.md).
///
/// Searches the triangles behind ab that come nearer to c than |ab|; gives up, with no, after a few. Exact where it
/// says yes. Precondition: the mesh is a Delaunay triangulation constrained by the edges of kFixedMark, all greedy.
[[nodiscard]] bool is_certain_ear(const PlanarMesh& mesh, const EdgeOrder& order, const Wedge& wedge);

}  // namespace mwt
