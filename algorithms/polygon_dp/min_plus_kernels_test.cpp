#include "algorithms/polygon_dp/min_plus_kernels.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "algorithms/exact/testing/instruction_sets.h"
#include "algorithms/polygon_dp/min_plus_scalar.h"

namespace mwt {
namespace {

using stage_testing::for_each_instruction_set;

struct alignas(64) Tile {
  std::array<TileCost, kTileArea> cost;
};

// Costs of all sizes and both signs, a fifth of them kNoCost.
class RandomCosts {
 public:
  TileCost draw() {
    if (random_() % 5 == 0) return kNoCost;
    const auto bits = static_cast<int>(random_() % 62);
    const auto size = static_cast<TileCost>(random_() >> (64 - std::max(bits, 1)));
    return random_() % 2 == 0 ? size : -size;
  }
  Tile tile() {
    Tile tile;
    for (TileCost& cost : tile.cost) cost = draw();
    return tile;
  }
  // Intervals of positive length only.
  Tile diagonal_tile() {
    Tile tile;
    for (std::size_t i = 0; i < kTile; ++i) {
      for (std::size_t j = 0; j < kTile; ++j) tile.cost[i * kTile + j] = i < j ? draw() : kNoCost;
    }
    return tile;
  }
  RowCosts row() {
    RowCosts costs;
    for (TileCost& chord : costs.chords) chord = random_() % 9 == 0 ? kNoCost : std::abs(draw()) / 4;
    for (TileCost& known : costs.known) known = random_() % 2 == 0 ? kNoCost : draw();
    return costs;
  }
  double coordinate() { return std::ldexp(static_cast<double>(random_() >> 11), -53) - 0.5; }

 private:
  std::mt19937_64 random_{1};
};

TEST(MinPlusKernels, MultiplyTilesAsThePlainLoops) {
  for_each_instruction_set([] {
    RandomCosts random;
    const auto left = std::make_unique<Tile>(random.tile()), right = std::make_unique<Tile>(random.tile());
    const auto result = std::make_unique<Tile>(random.tile()), expected = std::make_unique<Tile>(*result);
    multiply_tiles(left->cost.data(), right->cost.data(), result->cost.data());
    plain::multiply_tiles(left->cost.data(), right->cost.data(), expected->cost.data());
    ASSERT_EQ(result->cost, expected->cost);
  });
}

TEST(MinPlusKernels, FinishRowsAsThePlainLoops) {
  for_each_instruction_set([] {
    RandomCosts random;
    const auto rows = std::make_unique<Tile>(random.diagonal_tile());
    const auto columns = std::make_unique<Tile>(random.diagonal_tile());
    const auto result = std::make_unique<Tile>(random.tile()), expected = std::make_unique<Tile>(*result);
    for (std::size_t i = kTile; i-- > 0;) {
      const RowCosts costs = random.row();
      finish_row(i, rows->cost.data(), columns->cost.data(), costs, result->cost.data());
      plain::finish_row(i, rows->cost.data(), columns->cost.data(), costs, expected->cost.data());
      ASSERT_EQ(result->cost, expected->cost) << "row " << i;
    }
  });
}

TEST(MinPlusKernels, FinishRowsOnTheDiagonalAsThePlainLoops) {
  for_each_instruction_set([] {
    RandomCosts random;
    const auto result = std::make_unique<Tile>(), expected = std::make_unique<Tile>();
    result->cost.fill(kNoCost);
    expected->cost.fill(kNoCost);
    for (std::size_t i = kTile; i-- > 0;) {
      const RowCosts costs = random.row();
      finish_diagonal_row(i, costs, result->cost.data());
      plain::finish_diagonal_row(i, costs, expected->cost.data());
      ASSERT_EQ(result->cost, expected->cost) << "row " << i;
    }
  });
}

TEST(MinPlusKernels, MeasureChordsAsThePlainLoops) {
  for_each_instruction_set([] {
    RandomCosts random;
    std::array<double, kTile> x{}, y{};
    alignas(64) std::array<TileCost, kTile> lengths{}, expected{};
    for (const int exponent : {0, -30, -60, -500, -1070}) {
      for (std::size_t j = 0; j < kTile; ++j) {
        x[j] = std::ldexp(random.coordinate(), exponent);
        y[j] = std::ldexp(random.coordinate(), j % 3 == 0 ? exponent : 0);
      }
      const ChordRow row{random.coordinate(), random.coordinate(), x.data(), y.data(), 0x1p58};
      chord_lengths(row, lengths.data());
      plain::chord_lengths(row, expected.data());
      ASSERT_EQ(lengths, expected) << exponent;
    }
  });
}

}  // namespace
}  // namespace mwt
