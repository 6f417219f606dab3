// From triangles to a planar mesh: renumbers points and edges for locality and links the halfedges.
#pragma once

#include <vector>

#include "geometry/mesh/delaunay_triangles.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Builds one PlanarMesh; a helper of that class. Invariant of the result: the outer face lies left of side 1 of every
/// hull edge.
class MeshBuilder {
 public:
  explicit MeshBuilder(Points points);

  [[nodiscard]] PlanarMesh delaunay();
  [[nodiscard]] PlanarMesh given(const Triangulation& triangulation);

 private:
  [[nodiscard]] KeptVector<LinkedTriangle> linked(const Triangulation& triangulation) const;
  void order_triangles();
  void add_edges();
  void link_outer_face();
  PlanarMesh build(KeptVector<LinkedTriangle> triangles);

  PlanarMesh mesh_;
  KeptVector<LinkedTriangle> triangles_;
  KeptVector<std::uint32_t> order_;  // the real triangles by their first point
  std::vector<Halfedge> outer_;      // halfedges of the outer face
};

}  // namespace mwt
