// Edges that nothing can cross, as cuts that divide a large face into small ones.
#pragma once

#include <optional>
#include <span>

#include "algorithms/greedy/bounds/window_search.h"
#include "algorithms/greedy/greedy_marks.h"
#include "algorithms/greedy/wedge.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Finds edges that are certainly greedy because they are the shortest between two fixed edges at either end (lemma 10
/// in README.md), as those are that lead the shortest way from one boundary to another. They are few.
///
/// Floating point with a margin, rounded towards doubt: an edge that is said to be greedy is so under any tie rule.
/// Preconditions: the mesh is a Delaunay triangulation constrained by the edges of kFixedMark, all greedy; edges asked
/// for are none of them.
class FaceCuts {
 public:
  explicit FaceCuts(const PlanarMesh& mesh) : mesh_(mesh), search_(mesh) {}

  /// A guess, from a few thousand edges, whether there are enough cuts in the face to leave small ones. O(1).
  [[nodiscard]] bool is_promising(std::span<const MeshEdge> face) const;

  /// Such edges of a face; `face` holds all edges inside it. In linear time: gives up early if need be.
  [[nodiscard]] std::span<const MeshEdge> find(std::span<const MeshEdge> face);

 private:
  [[nodiscard]] bool is_shortest(MeshEdge e) const;
  [[nodiscard]] std::optional<Wedge> wedge_if_shortest(Halfedge h) const;
  [[nodiscard]] bool is_before_ear(Halfedge h, const Wedge& wedge) const;
  [[nodiscard]] bool shows_nothing_near(Halfedge h, std::size_t last_step);

  const PlanarMesh& mesh_;
  WindowSearch search_;
  KeptVector<MeshEdge> cuts_;
};

}  // namespace mwt
