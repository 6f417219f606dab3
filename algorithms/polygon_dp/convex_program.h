// An optimal triangulation of a convex polygon of thousands of vertices.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "algorithms/polygon_dp/convex_chords.h"
#include "algorithms/polygon_dp/interval_band.h"
#include "geometry/triangulation.h"

namespace mwt {

/// The dynamic program over all intervals of vertices, with lengths rounded down to integers: its least total is exact
/// for these, so the bound loses at most a unit per diagonal and 2^-50 of the total. Costs beyond kNoCost are kNoCost:
/// no optimal triangulation contains such a part.
///
/// n^3 / 6 sums, 4 n^2 bytes and a little (interval_band.h). Deterministic.
class ConvexProgram {
 public:
  /// Takes memory; throws std::bad_alloc if there is none. The chords must outlive this.
  explicit ConvexProgram(const ConvexChords& chords);

  /// Bytes that the program of a polygon with n vertices takes.
  [[nodiscard]] static std::uint64_t bytes(std::size_t n);

  /// Computes all costs, as IntervalBand::compute().
  [[nodiscard]] bool run(const Deadline& deadline, const std::function<void(double)>& progress = {});

  /// After run(): certified; the diagonals of no triangulation are shorter in total, in units of coordinates.
  [[nodiscard]] double diagonals_at_least() const;

  /// After run(): an optimal triangulation for the rounded lengths, in positions in the polygon and in the preorder of
  /// triangulate_polygon(). Of equal splits the first. O(n^2) at most, about n log n mostly.
  [[nodiscard]] std::vector<Triangle> triangles() const;

 private:
  const ConvexChords& chords_;
  IntervalBand band_;
};

}  // namespace mwt
