// A region of a proof on its own: what the ways of proving it share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/holes/local_region.h"
#include "algorithms/proof_trace.h"

namespace mwt {

/// What a region of a proof begins with. Places by local numbers: closed walks along the boundary, in any order, then
/// points that are on none; open edges by places, ascending. Where the boundary meets itself, any way to go on makes
/// closed walks in the end: there may be more of them than the boundary has components. No unit, no tree.
[[nodiscard]] DualRegion outline_of(const LocalRegion& local);

/// The region whose outline (places, walks, open edges by points of `local`) is given, and lengths in its unit. Both
/// must stay alive.
class OutlinedRegion {
 public:
  /// Optima have at most so many bits, in units.
  static constexpr int kBits = 56;

  OutlinedRegion(DualRegion& region, const LocalRegion& local);

  /// From the first to the second place of each.
  [[nodiscard]] const std::vector<Edge>& open_edges() const { return open_; }

  /// By local numbers.
  [[nodiscard]] FaceRegion as_face(std::size_t components) const;

  [[nodiscard]] double longest_edge() const;  ///< of the open ones

  /// Sets the region's unit for an optimum of about this length.
  void choose_unit(double length);

  /// Of a length, in units, rounded down.
  [[nodiscard]] std::int64_t half(Index a, Index b) const;

  /// What a triangulation with these diagonals proves at least if it is optimal, in units: others that are not shorter
  /// may be so by rounding, up to two units an edge.
  [[nodiscard]] std::int64_t target_of(std::span<const Edge> diagonals) const;

  /// States that the dual values prove so many units.
  void prove(std::int64_t units);

 private:
  DualRegion& region_;
  const LocalRegion& local_;
  std::vector<Edge> open_;
};

/// The total length of these edges, rounded.
[[nodiscard]] double total_length(Points points, std::span<const Edge> edges);

}  // namespace mwt
