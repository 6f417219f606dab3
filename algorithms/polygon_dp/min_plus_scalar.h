// The inner loops of the dynamic program for convex polygons, one interval at a time: the definition of what
// min_plus_kernels.cpp computes on vectors, function by function under the same names.
#pragma once

#include <algorithm>
#include <cmath>

#include "algorithms/polygon_dp/min_plus_kernels.h"

namespace mwt {

/// The cost of place j of a row whose best split costs `min_sum`.
[[nodiscard]] inline TileCost total_cost(TileCost min_sum, const RowCosts& costs, std::size_t j) {
  return std::max(std::min(min_sum + costs.chords[j], costs.known[j]), -kNoCost);
}

namespace plain {

inline void multiply_tiles(const TileCost* left, const TileCost* right, TileCost* result) {
  for (std::size_t i = 0; i < kTile; ++i) {
    for (std::size_t j = 0; j < kTile; ++j) {
      TileCost& cost = result[i * kTile + j];
      for (std::size_t k = 0; k < kTile; ++k) cost = std::min(cost, left[i * kTile + k] + right[k * kTile + j]);
    }
  }
}

inline void chord_lengths(const ChordRow& row, TileCost* lengths) {
  for (std::size_t j = 0; j < kTile; ++j) {
    const double dx = row.to_x[j] - row.from_x, dy = row.to_y[j] - row.from_y;
    lengths[j] = static_cast<TileCost>(std::sqrt(dx * dx + dy * dy) * row.units);
  }
}

inline void finish_row(std::size_t i, const TileCost* row_tile, const TileCost* column_tile, const RowCosts& costs,
                       TileCost* tile) {
  for (std::size_t j = 0; j < kTile; ++j) {
    TileCost& cost = tile[i * kTile + j];
    for (std::size_t k = i + 1; k < kTile; ++k) cost = std::min(cost, row_tile[i * kTile + k] + tile[k * kTile + j]);
    for (std::size_t k = 0; k < j; ++k) cost = std::min(cost, tile[i * kTile + k] + column_tile[k * kTile + j]);
    cost = total_cost(cost, costs, j);
  }
}

inline void finish_diagonal_row(std::size_t i, const RowCosts& costs, TileCost* tile) {
  for (std::size_t j = i + 1; j < kTile; ++j) {
    TileCost& cost = tile[i * kTile + j];
    for (std::size_t k = i + 1; k < j; ++k) cost = std::min(cost, tile[i * kTile + k] + tile[k * kTile + j]);
    cost = total_cost(cost, costs, j);
  }
}

}  // namespace plain

}  // namespace mwt
