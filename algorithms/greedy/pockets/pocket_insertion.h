// Puts the ears that were cut off a stretch of a boundary into the mesh.
#pragma once

#include "algorithms/greedy/faces/wedge.h"
#include "algorithms/greedy/greedy_parts.h"

namespace mwt {

class BoundaryStretch;

/// One pocket after the other; keeps its arrays.
class PocketInsertion {
 public:
  PocketInsertion(const GreedyParts& parts, BoundaryStretch& stretch) : parts_(parts), stretch_(stretch) {}

  /// Makes all ears between this corner and the next fixed edges of the mesh and restores the Delaunay property
  /// outside, once for all of them. The corner gets the longest of them as its side. Precondition: that pocket is not
  /// empty.
  void insert(Corner c);

 private:
  void insert_ear(Corner apex);
  [[nodiscard]] Halfedge join(Halfedge to, Halfedge from);
  [[nodiscard]] Halfedge from_previous(Corner apex) const;
  [[nodiscard]] Halfedge to_next(Corner apex) const;

  GreedyParts parts_;
  BoundaryStretch& stretch_;
  KeptVector<Corner> open_;  // apexes of ears that are to come into the mesh, after those that they hide
};

}  // namespace mwt
