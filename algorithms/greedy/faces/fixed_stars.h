// The fixed edges around each vertex: who comes next, also at vertices with tens of thousands of edges.
#pragma once

#include <vector>

#include "algorithms/greedy/greedy_marks.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Finds the fixed neighbours of a halfedge in the rotation about its origin. Where a scan of the star takes more than
/// a few steps, the vertex gets links between its fixed halfedges (which no flip moves). A new one is found its place
/// by scanning in both directions at once: that takes as many steps as there are edges on the nearer side, so that
/// splitting a star of d edges again and again takes O(d log d) in all, and wheels are no quadratic case.
class FixedStars {
 public:
  explicit FixedStars(PlanarMesh& mesh) : mesh_(mesh) {}

  /// The first fixed halfedge after h, counter-clockwise or clockwise; h itself if there is no other and h is fixed.
  /// Precondition: at least one halfedge at h's origin is fixed.
  [[nodiscard]] Halfedge left_of(Halfedge h) {
    if (is_linked(h)) return linked_neighbours(h).left;
    Halfedge other = mesh_.rotate_left(h);
    for (int steps = 0; steps < kScanLimit; ++steps, other = mesh_.rotate_left(other)) {
      if (is_fixed(mesh_, other)) return other;
    }
    return linked_neighbours(h).left;
  }
  [[nodiscard]] Halfedge right_of(Halfedge h) {
    if (is_linked(h)) return linked_neighbours(h).right;
    Halfedge other = mesh_.rotate_right(h);
    for (int steps = 0; steps < kScanLimit; ++steps, other = mesh_.rotate_right(other)) {
      if (is_fixed(mesh_, other)) return other;
    }
    return linked_neighbours(h).right;
  }

  /// Fixes an edge: marks it and makes it known to the stars of its ends.
  void fix(MeshEdge e) {
    mesh_.marks(e) |= kFixedMark;
    for (const Halfedge h : {2 * e, 2 * e + 1}) {
      if (is_linked(h)) link(h);
    }
  }

 private:
  static constexpr int kScanLimit = 24;
  struct Neighbours {
    Halfedge left;
    Halfedge right;
  };

  [[nodiscard]] bool is_linked(Halfedge h) const { return !is_linked_.empty() && is_linked_[mesh_.origin(h)]; }
  [[nodiscard]] Neighbours linked_neighbours(Halfedge h);
  [[nodiscard]] Neighbours find_neighbours(Halfedge h) const;
  void link(Halfedge h);
  void link_star(Halfedge h);

  PlanarMesh& mesh_;
  std::vector<bool> is_linked_;   // by vertex; empty until the first one is
  KeptVector<Neighbours> links_;  // set for all fixed halfedges at linked vertices, without a value for others
};

}  // namespace mwt
