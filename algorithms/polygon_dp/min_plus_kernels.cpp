#include "algorithms/polygon_dp/min_plus_kernels.h"

#include "algorithms/polygon_dp/min_plus_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algorithms/polygon_dp/min_plus_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mwt {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Costs = hn::CappedTag<TileCost, 8>;
using Reals = hn::RebindToFloat<Costs>;
using Vector = hn::Vec<Costs>;

// min_plus_scalar.h has each of the functions below in plain loops, with the same results.

constexpr Costs kCosts;
constexpr Reals kReals;

// Rows and vectors of the block of the result that stays in registers: as many as there are, less those for operands.
constexpr std::size_t kRows = HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL ? 8 : 4;

HWY_INLINE void multiply_block(const TileCost* HWY_RESTRICT left, const TileCost* HWY_RESTRICT right,
                               TileCost* HWY_RESTRICT result) {
  const std::size_t lanes = hn::Lanes(kCosts);
  Vector first[kRows], second[kRows];
  for (std::size_t r = 0; r < kRows; ++r) {
    first[r] = hn::Load(kCosts, result + r * kTile);
    second[r] = hn::Load(kCosts, result + r * kTile + lanes);
  }
  for (std::size_t k = 0; k < kTile; ++k) {
    const Vector right_first = hn::Load(kCosts, right + k * kTile);
    const Vector right_second = hn::Load(kCosts, right + k * kTile + lanes);
    for (std::size_t r = 0; r < kRows; ++r) {
      const Vector factor = hn::Set(kCosts, left[r * kTile + k]);
      first[r] = hn::Min(first[r], hn::Add(factor, right_first));
      second[r] = hn::Min(second[r], hn::Add(factor, right_second));
    }
  }
  for (std::size_t r = 0; r < kRows; ++r) {
    hn::Store(first[r], kCosts, result + r * kTile);
    hn::Store(second[r], kCosts, result + r * kTile + lanes);
  }
}

void MultiplyTiles(const TileCost* left, const TileCost* right, TileCost* result) {
  const std::size_t width = 2 * hn::Lanes(kCosts);
  for (std::size_t j = 0; j < kTile; j += width) {
    for (std::size_t i = 0; i < kTile; i += kRows) {
      multiply_block(left + i * kTile, right + j, result + i * kTile + j);
    }
  }
}

void ChordLengths(const ChordRow& row, TileCost* lengths) {
  const auto x = hn::Set(kReals, row.from_x), y = hn::Set(kReals, row.from_y), units = hn::Set(kReals, row.units);
  for (std::size_t j = 0; j < kTile; j += hn::Lanes(kReals)) {
    const auto dx = hn::Sub(hn::LoadU(kReals, row.to_x + j), x), dy = hn::Sub(hn::LoadU(kReals, row.to_y + j), y);
    const auto length = hn::Sqrt(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)));
    hn::Store(hn::ConvertTo(kCosts, hn::Mul(length, units)), kCosts, lengths + j);
  }
}

// row(j) = min(row(j), left + right(j)) for j from `begin` on.
HWY_INLINE void lower_row(TileCost left, const TileCost* HWY_RESTRICT right, TileCost* HWY_RESTRICT row,
                          std::size_t begin) {
  const std::size_t lanes = hn::Lanes(kCosts);
  const Vector addend = hn::Set(kCosts, left);
  std::size_t j = begin / lanes * lanes;
  if (j < begin) {
    const Vector before = hn::Load(kCosts, row + j);
    const Vector lowered = hn::Min(before, hn::Add(addend, hn::Load(kCosts, right + j)));
    hn::Store(hn::IfThenElse(hn::FirstN(kCosts, begin - j), before, lowered), kCosts, row + j);
    j += lanes;
  }
  for (; j < kTile; j += lanes) {
    const Vector sum = hn::Add(addend, hn::Load(kCosts, right + j));
    hn::Store(hn::Min(hn::Load(kCosts, row + j), sum), kCosts, row + j);
  }
}

void FinishRow(std::size_t i, const TileCost* row_tile, const TileCost* column_tile, const RowCosts& costs,
               TileCost* tile) {
  TileCost* const row = tile + i * kTile;
  for (std::size_t k = i + 1; k < kTile; ++k) lower_row(row_tile[i * kTile + k], tile + k * kTile, row, 0);
  for (std::size_t j = 0; j < kTile; ++j) {
    row[j] = total_cost(row[j], costs, j);
    lower_row(row[j], column_tile + j * kTile, row, j + 1);
  }
}

void FinishDiagonalRow(std::size_t i, const RowCosts& costs, TileCost* tile) {
  TileCost* const row = tile + i * kTile;
  for (std::size_t j = i + 1; j < kTile; ++j) {
    row[j] = total_cost(row[j], costs, j);
    lower_row(row[j], tile + j * kTile, row, j + 1);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mwt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mwt {

HWY_EXPORT(MultiplyTiles);
HWY_EXPORT(ChordLengths);
HWY_EXPORT(FinishRow);
HWY_EXPORT(FinishDiagonalRow);

void multiply_tiles(const TileCost* left, const TileCost* right, TileCost* result) {
  HWY_DYNAMIC_DISPATCH(MultiplyTiles)(left, right, result);
}

void chord_lengths(const ChordRow& row, TileCost* lengths) { HWY_DYNAMIC_DISPATCH(ChordLengths)(row, lengths); }

void finish_row(std::size_t i, const TileCost* row_tile, const TileCost* column_tile, const RowCosts& costs,
                TileCost* tile) {
  HWY_DYNAMIC_DISPATCH(FinishRow)(i, row_tile, column_tile, costs, tile);
}

void finish_diagonal_row(std::size_t i, const RowCosts& costs, TileCost* tile) {
  HWY_DYNAMIC_DISPATCH(FinishDiagonalRow)(i, costs, tile);
}

}  // namespace mwt
#endif
