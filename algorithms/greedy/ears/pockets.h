// Distant ears of a face's boundary, cut off in bulk: the mesh learns of them only when all are known.
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/greedy/boundary/boundary_stretch.h"
#include "algorithms/greedy/ears/distant_ears.h"
#include "algorithms/greedy/ears/pocket_insertion.h"

namespace mwt {

/// For long boundaries with nothing near them, such as a curve of many points: a look at an ear takes constant time,
/// however long it is, and each pocket comes into the mesh at once.
class Pockets {
 public:
  Pockets(PlanarMesh& mesh, const EdgeOrder& order, FixedStars& stars, EarInsertion& insertion, const Context& context)
      : context_(context), stretch_(mesh), ears_(mesh, order, stretch_), insertion_(mesh, stars, insertion, stretch_) {}

  /// Whether take() is worth while, from a sample.
  [[nodiscard]] bool is_promising(FaceBoundary& boundary) { return ears_.is_promising(boundary); }

  /// Cuts distant ears off the boundary, none of whose corners is cut, and fixes them in the mesh, stretch by stretch
  /// of so many corners: they fit the cache with the longest of their ears. Gives up when it meets too much that is
  /// near. Stops at the deadline. Exact; linear time but for the flips that restore the Delaunay property.
  /// Precondition: the mesh is a Delaunay triangulation constrained by the edges of kFixedMark, all greedy.
  void take(FaceBoundary& boundary, std::size_t stretch = 1 << 16);

  /// Ears taken so far that were no edges of the mesh before, as far as known.
  [[nodiscard]] std::size_t inserted() const { return inserted_; }

 private:
  static constexpr int kOverlap = 40;  // so many corners that are left, on either side of a stretch

  [[nodiscard]] bool take_stretch(FaceBoundary& boundary, std::size_t from);
  void cut_ears(Corner first, Corner last);
  void wait(Corner c);

  const Context& context_;
  std::size_t size_ = 0;  // of a stretch
  BoundaryStretch stretch_;
  DistantEars ears_;
  PocketInsertion insertion_;
  KeptVector<Corner> waiting_;  // corners to be looked at
  std::size_t inserted_ = 0;
};

}  // namespace mwt
