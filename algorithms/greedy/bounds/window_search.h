// What is seen from a vertex through the opposite side of one of its triangles.
#pragma once

#include <array>
#include <cstddef>

#include "algorithms/greedy/greedy_marks.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Looks for near points behind fixed edges' ends. Keeps count of its work.
class WindowSearch {
 public:
  explicit WindowSearch(const PlanarMesh& mesh) : mesh_(mesh) {}

  /// Whether every point that is visible from c, the apex of the triangle left of `window`, through that side is
  /// farther from c than sqrt(`squared`). No, if finding out takes more than `max_steps`.
  ///
  /// Floating point with a margin, rounded towards no. Preconditions: the mesh is a Delaunay triangulation constrained
  /// by the edges of kFixedMark; squares of its lengths are in the range of doubles.
  [[nodiscard]] bool shows_nothing_near(Halfedge window, double squared, std::size_t max_steps);

  /// Triangles looked at so far.
  [[nodiscard]] std::size_t steps() const { return steps_; }

 private:
  static constexpr std::size_t kMaxWindows = 32;

  [[nodiscard]] bool open(Halfedge window);
  [[nodiscard]] int side_of(Index v) const;
  [[nodiscard]] double squared_distance(Index v) const;

  const PlanarMesh& mesh_;
  std::size_t steps_ = 0;
  double squared_ = 0;
  Point c_{}, from_{}, to_{};                    // the viewer and the ends of the first window
  std::array<Halfedge, kMaxWindows> windows_{};  // still to be looked through, away from c
  std::size_t count_ = 0;
};

}  // namespace mwt
