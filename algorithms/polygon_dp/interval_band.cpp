#include "algorithms/polygon_dp/interval_band.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <atomic>
#include <chrono>

namespace mwt {

namespace {

using Clock = std::chrono::steady_clock;

// In products of tiles; completing a tile takes as long as two or three.
double work_of_diagonal(std::size_t columns, std::size_t distance) {
  constexpr double kCompletion = 2.5;
  const double products = distance > 1 ? static_cast<double>(distance - 1) : 0;
  return static_cast<double>(columns - distance) * (kCompletion + products);
}

// Extrapolates the time of the whole work from the part that is done.
class Forecast {
 public:
  Forecast(std::size_t columns, std::size_t reach, const Deadline& deadline) : deadline_(deadline) {
    for (std::size_t distance = 0; distance <= reach; ++distance) total_ += work_of_diagonal(columns, distance);
  }

  void add(double work) { done_ += work; }
  [[nodiscard]] double share() const { return done_ / total_; }

  [[nodiscard]] bool is_hopeless() const {
    constexpr double kEnough = 0.03;  // what came before says little
    constexpr double kDoubt = 1.5;    // the machine may become faster
    if (!deadline_ || share() < kEnough) return false;
    const std::chrono::duration<double> taken = deadline_clock() - start_, given = *deadline_ - start_;
    return taken.count() > kDoubt * share() * given.count();
  }

 private:
  Deadline deadline_;
  Clock::time_point start_ = deadline_clock();
  double total_ = 0;
  double done_ = 0;
};

}  // namespace

std::size_t IntervalBand::tiles_before(std::size_t column, std::size_t reach) {
  if (column <= reach + 1) return column * (column + 1) / 2;
  return (reach + 1) * (reach + 2) / 2 + (column - reach - 1) * (reach + 1);
}

std::uint64_t IntervalBand::bytes(std::size_t positions, std::size_t reach) {
  return tiles_before(tile_columns(positions), reach) * kTileArea * sizeof(TileCost);
}

IntervalBand::IntervalBand(std::size_t positions, std::size_t reach)
    : positions_(positions),
      columns_(tile_columns(positions)),
      reach_(std::min(reach, columns_ - 1)),
      tiles_(static_cast<TileCost*>(::operator new[](bytes(positions, reach_), std::align_val_t{kAlignment}))) {}

bool IntervalBand::compute(const RowSource& source, const Deadline& deadline,
                           const std::function<void(double)>& progress) {
  Forecast forecast(columns_, reach_, deadline);
  std::atomic<bool> is_late = false;
  for (std::size_t distance = 0; distance <= reach_; ++distance) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, columns_ - distance, 1),
        [&](const tbb::blocked_range<std::size_t>& rows) {
          for (std::size_t row = rows.begin(); row < rows.end() && !is_late; ++row) {
            if (!compute_tile(row, row + distance, source, deadline)) is_late = true;
          }
        },
        tbb::simple_partitioner());
    forecast.add(work_of_diagonal(columns_, distance));
    if (is_late || forecast.is_hopeless()) return false;
    if (progress) progress(forecast.share());
  }
  return true;
}

// False if the deadline passes first. Splits between the tile's rows and columns first, then those at its own.
bool IntervalBand::compute_tile(std::size_t row, std::size_t column, const RowSource& source,
                                const Deadline& deadline) const {
  TileCost* const result = tile(row, column);
  std::fill_n(result, kTileArea, kNoCost);
  for (std::size_t k = row + 1; k < column; ++k) {
    if (has_passed(deadline)) return false;
    multiply_tiles(tile(row, k), tile(k, column), result);
  }
  RowCosts costs;
  costs.chords.fill(kNoCost);
  costs.known.fill(kNoCost);
  for (std::size_t i = std::min(kTile, positions_ - row * kTile); i-- > 0;) {
    source(row * kTile + i, column * kTile, costs);
    if (row == column) {
      finish_diagonal_row(i, costs, result);
    } else {
      finish_row(i, tile(row, row), tile(column, column), costs, result);
    }
  }
  return !has_passed(deadline);
}

std::size_t IntervalBand::best_split(std::size_t i, std::size_t j) const {
  std::size_t best = i + 1;
  TileCost least = cost(i, best) + cost(best, j);
  for (std::size_t k = i + 2; k < j; ++k) {
    const TileCost sum = cost(i, k) + cost(k, j);
    if (sum >= least) continue;
    least = sum;
    best = k;
  }
  return best;
}

}  // namespace mwt
