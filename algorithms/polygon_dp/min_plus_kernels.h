// The inner loops of the dynamic program for convex polygons: minima of sums of integers, tile by tile.
//
// Intervals (i, j) of positions lie in square tiles of kTile x kTile, row i, column j, in row-major order. Costs are
// integers, so that no addition rounds; kNoCost stands for what is impossible.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace mwt {

inline constexpr std::size_t kTile = 128;
inline constexpr std::size_t kTileArea = kTile * kTile;

/// Costs are between -kNoCost and kNoCost, so that no sum of three overflows.
inline constexpr std::int64_t kNoCost = std::int64_t{1} << 61;

using TileCost = std::int64_t;

/// result(i, j) = min(result(i, j), min over k of left(i, k) + right(k, j)): for splits between the tiles' positions.
void multiply_tiles(const TileCost* left, const TileCost* right, TileCost* result);

/// Chords of a row of positions: from `from` to kTile places, lengths in units, rounded down.
struct ChordRow {
  double from_x;
  double from_y;
  const double* to_x;
  const double* to_y;
  double units;  ///< per unit of coordinates
};
/// Precondition: no length is kNoCost units or more.
void chord_lengths(const ChordRow& row, TileCost* lengths);

/// What one row of a tile gets besides its splits: cost = min(chord + least sum over the splits, known), but at least
/// -kNoCost.
struct RowCosts {
  alignas(64) std::array<TileCost, kTile> chords;  ///< kNoCost: no chord
  alignas(64) std::array<TileCost, kTile> known;
};

/// Completes row i of a tile off the diagonal, rows after i being complete, from splits at positions of the tile's rows
/// and columns: `row_tile` and `column_tile` are the tiles on the diagonal of its rows and columns.
void finish_row(std::size_t i, const TileCost* row_tile, const TileCost* column_tile, const RowCosts& costs,
                TileCost* tile);

/// Completes row i of a tile on the diagonal, rows after i being complete.
void finish_diagonal_row(std::size_t i, const RowCosts& costs, TileCost* tile);

}  // namespace mwt
