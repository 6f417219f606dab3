// The chords of a convex polygon with their lengths in integers.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/polygon_dp/min_plus_kernels.h"
#include "geometry/point.h"

namespace mwt {

/// The vertices of a convex polygon, counter-clockwise, in double precision relative to its size, and the unit in which
/// integers measure chords.
///
/// Property, for a chord of true length l (in units of coordinates) and its integer L:
///   (1 - 2^-51) L unit <= l <= (1 + 2^-51) (L + 1) unit.
/// Proof: a rounded difference, product, sum and root err by 2^-53 of themselves each, so the length by less than
/// 3.1 * 2^-53; scaling by powers of two is exact; what underflows is below 2^-400 of the polygon's extent, and a unit
/// is at least 2^-64 of it; the rest is cut off.
class ConvexChords {
 public:
  /// `polygon`: at least 3 vertices in convex position, counter-clockwise, the first of them a strict corner; vertices
  /// along a side allowed. `weight_at_most`: that of some triangulation, rounded up: at most kMaxCost units.
  ConvexChords(Points polygon, double weight_at_most);

  static constexpr TileCost kMaxCost = kNoCost / 2;

  [[nodiscard]] std::size_t size() const { return size_; }

  // Vertices go on from size() to 2 size() for a second time around.

  /// The lengths of the chords from vertex i to vertices first .. first + kTile - 1, kNoCost for those along a side.
  /// Anything for places that are not after i or beyond the last vertex.
  void lengths_from(std::size_t i, std::size_t first, TileCost* lengths) const;
  /// One of them, perhaps one unit off.
  [[nodiscard]] TileCost length(std::size_t i, std::size_t j) const;

  /// Whether the chord from i to j is no diagonal because it runs along a side. Precondition: i < j < i + size().
  [[nodiscard]] bool runs_along_side(std::size_t i, std::size_t j) const {
    return j > i + 1 && j <= side_end_[i % size_] + i - i % size_;
  }

  /// Coordinates of vertex i < 2 size(), relative to those of vertex 0 and in units of about the polygon's extent.
  /// They err by 2^-52 at most.
  [[nodiscard]] Point local(std::size_t i) const { return {x_[i] - x_[0], y_[i] - y_[0]}; }
  /// How many units have the length of `local` coordinates, rounded down with a margin for their errors; at least 0.
  [[nodiscard]] TileCost units_at_most(double local_length) const;

  /// A certified lower bound on the true total of chords whose integers add up to `cost`, in units of coordinates.
  [[nodiscard]] double true_length_at_least(TileCost cost) const;

 private:
  std::size_t size_;
  int exponent_ = 0;                   // coordinates are divided by 2^exponent_
  int units_exponent_ = 0;             // 2^units_exponent_ units are the unit of divided coordinates
  std::vector<double> x_, y_;          // divided, twice around and a tile more
  std::vector<std::size_t> side_end_;  // by vertex i: the last one on the line through i and i + 1
};

}  // namespace mwt
