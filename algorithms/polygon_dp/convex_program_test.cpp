#include "algorithms/polygon_dp/convex_program.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <optional>
#include <random>

#include "algorithms/exact/testing/instruction_sets.h"
#include "algorithms/polygon_dp/polygon_dp.h"
#include "algorithms/polygon_dp/testing/convex_polygons.h"
#include "geometry/checker.h"

namespace mwt {
namespace {

using convex_testing::cycle_of;
using convex_testing::polygons;
using convex_testing::weight_of;
using stage_testing::for_each_instruction_set;

// Costs by the definition, intervals by length.
std::vector<std::vector<TileCost>> naive_costs(std::size_t n, const std::vector<std::vector<TileCost>>& chord) {
  std::vector<std::vector<TileCost>> cost(n, std::vector<TileCost>(n, kNoCost));
  for (std::size_t length = 1; length < n; ++length) {
    for (std::size_t i = 0; i + length < n; ++i) {
      const std::size_t j = i + length;
      TileCost least = length == 1 ? 0 : kNoCost;
      for (std::size_t k = i + 1; k < j; ++k) least = std::min(least, cost[i][k] + cost[k][j]);
      cost[i][j] = length == 1 ? 0 : std::min(least + chord[i][j], kNoCost);
    }
  }
  return cost;
}

TEST(IntervalBand, HasTheCostsOfTheDefinition) {
  for (const std::size_t n : {3U, 127U, 128U, 129U, 300U, 513U}) {
    std::mt19937_64 random(n);
    std::vector<std::vector<TileCost>> chord(n, std::vector<TileCost>(n));
    for (auto& row : chord) {
      for (TileCost& cost : row) cost = random() % 10 == 0 ? kNoCost : static_cast<TileCost>(random() % 1000);
    }
    const auto expected = naive_costs(n, chord);
    for (const std::size_t reach : {std::size_t{1}, std::size_t{2}, IntervalBand::full_reach(n)}) {
      IntervalBand band(n, reach);
      ASSERT_TRUE(band.compute(
          [&](std::size_t i, std::size_t first, RowCosts& costs) {
            for (std::size_t j = std::max(i + 1, first); j < std::min(n, first + kTile); ++j) {
              costs.chords[j - first] = chord[i][j];
              costs.known[j - first] = j == i + 1 ? 0 : kNoCost;
            }
          },
          {}));
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n && band.covers(i, j); ++j) {
          ASSERT_EQ(band.cost(i, j), expected[i][j]) << n << ' ' << reach << ' ' << i << ' ' << j;
        }
      }
      EXPECT_TRUE(n - 1 <= band.longest() ? band.covers(0, n - 1) : band.covers(n - 1 - band.longest(), n - 1));
    }
  }
}

// What some triangulation weighs at most, well above the optimum, as heuristics may give it.
double weight_at_most(const std::vector<Point>& vertices) {
  return triangulate_polygon(vertices, cycle_of(vertices), PolygonObjective::edges).cost.upper * 1.5;
}

TEST(ConvexProgram, FindsTheOptimaOfTheGeneralProgram) {
  for (const Index n : {5U, 100U, 128U, 129U, 130U, 257U, 400U}) {
    for (const auto& [name, vertices] : polygons(n)) {
      SCOPED_TRACE(name);
      const PolygonTriangulation expected = triangulate_polygon(vertices, cycle_of(vertices), PolygonObjective::edges);
      const ConvexChords chords(vertices, weight_at_most(vertices));
      ConvexProgram program(chords);
      ASSERT_TRUE(program.run({}));
      const std::vector<Triangle> triangles = program.triangles();
      EXPECT_FALSE(find_violation(vertices, {static_cast<Index>(vertices.size()), triangles}));
      const Interval found = weight_of(vertices, triangles);
      EXPECT_LE(found.lower, expected.cost.upper * (1 + 1e-13));
      const double lower = cycle_length(vertices, cycle_of(vertices)).lower + program.diagonals_at_least();
      EXPECT_LE(lower, expected.cost.upper);
      EXPECT_GE(lower, expected.cost.lower * (1 - 1e-13));
    }
  }
}

TEST(ConvexProgram, DoesNotDependOnThreadsOrInstructionSets) {
  for (const auto& [name, vertices] : polygons(300)) {
    SCOPED_TRACE(name);
    const ConvexChords chords(vertices, weight_at_most(vertices));
    std::optional<std::vector<Triangle>> expected;
    for_each_instruction_set([&] {
      for (const int threads : {1, 2}) {
        tbb::task_arena arena(threads);
        arena.execute([&] {
          ConvexProgram program(chords);
          ASSERT_TRUE(program.run({}));
          if (!expected) expected = program.triangles();
          EXPECT_EQ(program.triangles(), *expected) << threads << " threads";
        });
      }
    });
  }
}

TEST(ConvexProgram, StopsAtTheDeadline) {
  const std::vector<Point> vertices = convex_testing::hull_cycle(generate("circle", 600, 1));
  const ConvexChords chords(vertices, 1e4);
  ConvexProgram program(chords);
  EXPECT_FALSE(program.run(std::chrono::steady_clock::now()));
}

}  // namespace
}  // namespace mwt
