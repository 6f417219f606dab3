// Dual values of a polygon's dynamic program, in integers: the verifier checks them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/proof_trace.h"
#include "geometry/numbers/double_double.h"
#include "geometry/point.h"

namespace mwt {

/// All diagonals of a convex polygon by positions in `corners`, ascending; corners may lie in the middle of its sides.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> diagonals_of_convex_polygon(Points points,
                                                                                    std::span<const Index> corners);

/// Makes regions of polygons one after the other in the same memory. Not for concurrent use: one object per thread.
class PolygonDuals {
 public:
  /// No polygon with an optimum costs so many units; sums of three fit easily.
  static constexpr std::int64_t kNever = std::int64_t{1} << 58;

  /// What solve() takes, its result included.
  [[nodiscard]] static constexpr std::uint64_t bytes_for(std::size_t diagonals) {
    return std::uint64_t{80} * diagonals;
  }

  /// The region of the weakly simple polygon `corners`, which lies to its left, and of its `diagonals`, by positions in
  /// `corners`, first < second, ascending. Its dual values prove the length of the lightest triangulation by these
  /// diagonals, less than 1e-12 of it lost to rounding; nothing (0) if there is none.
  ///
  /// The interval program over positions in integers: lengths in units of the region, halved and rounded down. The side
  /// of a diagonal from its later to its earlier end gets what the polygon on that side costs at least, with half the
  /// diagonal, and the other side the negative of that; the last side of the polygon gets the optimum.
  ///
  /// With a unit given, that is taken, and what costs kNever units or more, or has no triangulation, is proved to cost
  /// at least kNever.
  ///
  /// Nothing if the deadline passes. Time as the program itself: the sum over the diagonals of the diagonals at one of
  /// their ends.
  [[nodiscard]] std::optional<DualRegion> solve(Points points, std::span<const Index> corners,
                                                std::span<const std::array<std::uint32_t, 2>> diagonals,
                                                const Deadline& deadline, std::optional<int> unit_exponent = {});

 private:
  using Position = std::uint32_t;
  struct BackwardCell {
    Position from;
    std::int64_t value;
  };

  void measure(Points points, std::span<const Index> corners);
  void lay_out_cells(std::size_t size);
  std::optional<std::int64_t> run(int unit_exponent, const Deadline& deadline);
  void run_row(Position from);
  [[nodiscard]] std::int64_t min_sum(Position from, Position to, std::size_t first_cell, std::size_t cell) const;
  std::optional<std::int64_t> run_in_good_unit(int& exponent, const Deadline& deadline);

  std::span<const std::array<Position, 2>> diagonals_;
  std::vector<Point> points_;       // of the corners
  std::vector<std::size_t> first_;  // diagonals from position i: first_[i] .. first_[i + 1]
  std::vector<DoubleDouble> lengths_;
  double longest_ = 0;
  std::vector<std::int64_t> half_;       // of each diagonal
  std::vector<std::int64_t> dual_;       // of its side from its later to its earlier end
  std::vector<std::int64_t> row_value_;  // by the later end
  std::vector<std::size_t> backward_first_, backward_end_;
  std::vector<BackwardCell> backward_;  // by the later end, descending by the earlier one
};

}  // namespace mwt
