// Which flips shorten a triangulation, and by how much.
#pragma once

#include <array>

#include "geometry/mesh/distance.h"
#include "geometry/mesh/planar_mesh.h"
#include "geometry/predicates.h"

namespace mwt {

/// The other edges of the two triangles at e. Precondition: not a hull edge.
[[nodiscard]] inline std::array<MeshEdge, 4> sides_of(const PlanarMesh& mesh, MeshEdge e) {
  const Halfedge h = 2 * e;
  return {edge_of(mesh.next(h)), edge_of(mesh.previous(h)), edge_of(mesh.next(h + 1)), edge_of(mesh.previous(h + 1))};
}

/// Whether flipping e shortens the triangulation. Exact. Lengths first: they decide most cases.
[[nodiscard]] inline bool improves(const PlanarMesh& mesh, MeshEdge e) {
  if (mesh.is_hull(e)) return false;
  const Halfedge h = 2 * e;
  return compare_length(mesh.point(mesh.apex(h)), mesh.point(mesh.apex(h + 1)), mesh.point(mesh.origin(h)),
                        mesh.point(mesh.target(h))) < 0 &&
         mesh.is_flippable(e);
}

/// What flipping e gains in the mesh's unit, rounded: for comparing flips that improve, not for telling whether one
/// does.
[[nodiscard]] inline double gain_of(const PlanarMesh& mesh, MeshEdge e) {
  const Halfedge h = 2 * e;
  return rounded_distance(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h))) -
         rounded_distance(mesh.point(mesh.apex(h)), mesh.point(mesh.apex(h + 1)));
}

}  // namespace mwt
