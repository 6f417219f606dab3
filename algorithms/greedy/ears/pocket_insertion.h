// Puts the ears that were cut off a stretch of a boundary into the mesh.
#pragma once

#include <vector>

#include "algorithms/greedy/boundary/boundary_stretch.h"
#include "algorithms/greedy/ears/ear_insertion.h"
#include "algorithms/greedy/faces/fixed_stars.h"

namespace mwt {

/// One pocket after the other; keeps its arrays.
class PocketInsertion {
 public:
  PocketInsertion(PlanarMesh& mesh, FixedStars& stars, EarInsertion& insertion, BoundaryStretch& stretch)
      : mesh_(mesh), stars_(stars), insertion_(insertion), stretch_(stretch) {}

  /// Makes all ears between this corner and the next fixed edges of the mesh and restores the Delaunay property
  /// outside. The corner gets the longest of them as its side. Precondition: that pocket is not empty. One flip for
  /// each spoke of a convex pocket, where ears one after the other would flip it for each ear that hides its end; and
  /// those of EarInsertion::restore_delaunay.
  void insert(Corner c);

 private:
  [[nodiscard]] bool hides_convex_polygon(Corner apex) const;
  void insert_ear(Corner apex);
  void insert_fan(Corner apex);
  void link_ears(Corner root);
  [[nodiscard]] Halfedge join(Halfedge to, Halfedge from);
  [[nodiscard]] Halfedge from_previous(Corner apex) const;
  [[nodiscard]] Halfedge to_next(Corner apex) const;

  PlanarMesh& mesh_;
  FixedStars& stars_;
  EarInsertion& insertion_;
  BoundaryStretch& stretch_;
  KeptVector<Corner> open_;   // apexes of ears that are to come into the mesh, after those that they hide
  KeptVector<MeshEdge> fan_;  // its edges give way to ears
};

}  // namespace mwt
