// The dynamic program over intervals of positions, in integers, by tiles, on all threads.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <new>

#include "algorithms/deadline.h"
#include "algorithms/polygon_dp/min_plus_kernels.h"

namespace mwt {

/// Costs of intervals (i, j), i < j, of a row of positions, as long as they are not too long for the band:
///   cost(i, j) = min(known(i, j), chord(i, j) + min over i < k < j of cost(i, k) + cost(k, j)),
/// where what is below -kNoCost becomes that. Costs are integers, so that nothing rounds (min_plus_kernels.h).
///
/// Tiles of kTile x kTile intervals, diagonal by diagonal; the tiles of one are independent. All but a few per cent of
/// the work are products of tiles that lie in cache: about 10^10 sums per second and thread with AVX2, half as many
/// again with AVX-512. Runs on the threads of the enclosing task arena; the result does not depend on them.
class IntervalBand {
 public:
  /// Fills in what intervals (i, first), .. (i, first + kTile - 1) get besides their splits; anything where the second
  /// position is not after i or beyond the last one. Is called from several threads at a time.
  using RowSource = std::function<void(std::size_t i, std::size_t first, RowCosts& costs)>;

  /// A band of tiles up to `reach` columns right of the diagonal: all intervals up to reach * kTile long. Takes memory;
  /// throws std::bad_alloc if there is none.
  IntervalBand(std::size_t positions, std::size_t reach);

  /// Bytes that such a band takes.
  [[nodiscard]] static std::uint64_t bytes(std::size_t positions, std::size_t reach);
  /// The reach with which a band covers all intervals.
  [[nodiscard]] static std::size_t full_reach(std::size_t positions) { return tile_columns(positions) - 1; }

  /// Computes all costs; calls progress(share of the work done), if given, now and then. False if the deadline passes
  /// first, or will before the end by what the work took so far.
  [[nodiscard]] bool compute(const RowSource& source, const Deadline& deadline,
                             const std::function<void(double)>& progress = {});

  [[nodiscard]] std::size_t positions() const { return positions_; }
  [[nodiscard]] std::size_t longest() const { return reach_ * kTile; }

  /// Whether the band holds the interval. Precondition: i < j < positions().
  [[nodiscard]] bool covers(std::size_t i, std::size_t j) const { return j / kTile - i / kTile <= reach_; }
  [[nodiscard]] TileCost cost(std::size_t i, std::size_t j) const {
    return tile(i / kTile, j / kTile)[i % kTile * kTile + j % kTile];
  }
  /// The first of the best splits of an interval at least 2 long.
  [[nodiscard]] std::size_t best_split(std::size_t i, std::size_t j) const;

 private:
  struct Release {
    void operator()(TileCost* tiles) const { ::operator delete[](tiles, std::align_val_t{kAlignment}); }
  };
  static constexpr std::size_t kAlignment = 64;

  [[nodiscard]] static std::size_t tile_columns(std::size_t positions) { return (positions + kTile - 1) / kTile; }
  // Tiles of the columns before this one, of which the first ones are shorter.
  [[nodiscard]] static std::size_t tiles_before(std::size_t column, std::size_t reach);
  [[nodiscard]] TileCost* tile(std::size_t row, std::size_t column) const {
    const std::size_t first = column > reach_ ? column - reach_ : 0;
    return &tiles_[(tiles_before(column, reach_) + row - first) * kTileArea];
  }
  [[nodiscard]] bool compute_tile(std::size_t row, std::size_t column, const RowSource& source,
                                  const Deadline& deadline) const;

  std::size_t positions_;
  std::size_t columns_;  // of tiles
  std::size_t reach_;
  std::unique_ptr<TileCost[], Release> tiles_;
};

}  // namespace mwt
