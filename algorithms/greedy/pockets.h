// Distant ears of a face's boundary, cut off in bulk: the mesh learns of them only when all are known.
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/greedy/boundary_stretch.h"
#include "algorithms/greedy/distant_ears.h"
#include "algorithms/greedy/pocket_insertion.h"

namespace mwt {

/// For long boundaries with nothing near them, such as a curve of many points: a look at an ear takes constant time,
/// however long it is, and each pocket comes into the mesh at once.
class Pockets {
 public:
  Pockets(PlanarMesh& mesh, const EdgeOrder& order, FixedStars& stars, EarInsertion& insertion, const Context& context)
      : context_(context), stretch_(mesh), ears_(mesh, order, stretch_), insertion_(mesh, stars, insertion, stretch_) {}

  /// Cuts distant ears off the boundary, none of whose corners is cut, and fixes them in the mesh, stretch by stretch.
  /// Does nothing where that is not worth while. Stops at the deadline. Exact; linear time but for the flips that
  /// restore the Delaunay property. Precondition: the mesh is a Delaunay triangulation constrained by the edges of
  /// kFixedMark, all greedy.
  void take(FaceBoundary& boundary);

  /// Ears taken so far that were no edges of the mesh before, as far as known.
  [[nodiscard]] std::size_t inserted() const { return inserted_; }

 private:
  static constexpr std::size_t kStretch = 1 << 16;  // so many corners, with the longest of their ears, fit the cache
  static constexpr int kOverlap = 40;               // so many corners that are left, on either side

  [[nodiscard]] bool take_stretch(FaceBoundary& boundary, std::size_t first);
  void cut_ears(Corner first, Corner last);
  void wait(Corner c);

  const Context& context_;
  BoundaryStretch stretch_;
  DistantEars ears_;
  PocketInsertion insertion_;
  std::vector<Corner> waiting_;  // corners to be looked at
  std::size_t inserted_ = 0;
};

}  // namespace mwt
