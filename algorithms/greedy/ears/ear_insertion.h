// Puts an ear, an edge that cuts off a corner between two fixed edges, into the constrained Delaunay triangulation.
#pragma once

#include <span>
#include <vector>

#include "algorithms/greedy/faces/wedge.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

class FixedStars;

/// One insertion after the other; keeps its arrays.
class EarInsertion {
 public:
  EarInsertion(PlanarMesh& mesh, FixedStars& stars) : mesh_(mesh), stars_(stars) {}

  /// Makes the wedge's third side an edge by flipping out the spokes between, which leaves them inside the region that
  /// they crossed, and restores the Delaunay property there. Returns that edge, not yet fixed.
  /// Preconditions: the closed triangle of the wedge holds no other point, and there is at least one spoke. Exact.
  /// O(spokes^2) flips, a few per spoke in practice.
  MeshEdge insert(const Wedge& wedge);

  /// The same in steps, for several wedges: begin, flip_out each, restore_delaunay. After the last step, as many edges
  /// as before; those that the caller fixed in between are left alone.
  void begin();
  MeshEdge flip_out(const Wedge& wedge);
  void restore_delaunay();

  /// The edges inside the region of the last insertion: all that were flipped but the one that was returned.
  [[nodiscard]] std::span<const MeshEdge> inner() const { return inner_; }

  /// First halfedges of wedges that lost an edge with a kWatchedMark to the last insertion.
  [[nodiscard]] std::span<const Halfedge> unblocked() const { return unblocked_; }

  [[nodiscard]] std::size_t flips() const { return flips_; }

 private:
  void flip(MeshEdge e);

  PlanarMesh& mesh_;
  FixedStars& stars_;
  std::size_t flips_ = 0;
  std::vector<Halfedge> spokes_;
  std::vector<MeshEdge> inner_;
  std::vector<MeshEdge> suspects_;
  std::vector<Halfedge> unblocked_;
};

}  // namespace mwt
