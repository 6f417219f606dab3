// The fixed edges around each vertex: who comes next, also at vertices with tens of thousands of edges.
#pragma once

#include <functional>
#include <set>
#include <unordered_map>

#include "algorithms/greedy/greedy_marks.h"
#include "algorithms/mesh/planar_mesh.h"

namespace mwt {

/// Finds the fixed neighbours of a halfedge in the rotation about its origin. Where a scan of the star takes more than
/// a few steps, the vertex gets an ordered set of its fixed halfedges (which no flip moves), so that a query costs
/// O(log degree) and wheels are no quadratic case.
class FixedStars {
 public:
  explicit FixedStars(const PlanarMesh& mesh) : mesh_(mesh) {}

  /// The first fixed halfedge after h, counter-clockwise or clockwise; h itself if there is no other and h is fixed.
  /// Precondition: at least one halfedge at h's origin is fixed.
  [[nodiscard]] Halfedge left_of(Halfedge h) {
    Halfedge other = mesh_.rotate_left(h);
    for (int steps = 0; steps < kScanLimit; ++steps, other = mesh_.rotate_left(other)) {
      if (is_fixed(other)) return other;
    }
    return left_in_set(h);
  }
  [[nodiscard]] Halfedge right_of(Halfedge h) {
    Halfedge other = mesh_.rotate_right(h);
    for (int steps = 0; steps < kScanLimit; ++steps, other = mesh_.rotate_right(other)) {
      if (is_fixed(other)) return other;
    }
    return right_in_set(h);
  }

  [[nodiscard]] bool is_fixed(Halfedge h) const { return (mesh_.marks(edge_of(h)) & kFixedMark) != 0; }

  /// To be called for both halves of an edge once it is fixed.
  void add(Halfedge h) {
    if (stars_.empty()) return;
    if (const auto star = stars_.find(mesh_.origin(h)); star != stars_.end()) star->second.insert(h);
  }

 private:
  static constexpr int kScanLimit = 24;
  using Star = std::set<Halfedge, std::function<bool(Halfedge, Halfedge)>>;

  [[nodiscard]] Halfedge left_in_set(Halfedge h);
  [[nodiscard]] Halfedge right_in_set(Halfedge h);
  [[nodiscard]] Star& star_of(Halfedge h);

  const PlanarMesh& mesh_;
  std::unordered_map<Index, Star> stars_;
};

}  // namespace mwt
