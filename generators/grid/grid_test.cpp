#include "generators/grid/grid.h"

#include <gtest/gtest.h>

#include "generators/testing.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

TEST(Grid, points_are_the_recorded_ones) { EXPECT_EQ(golden_hash("grid", 100, 1), "4760c25233cbade8d8f5f86fec7f83e4"); }

TEST(Grid, a_square_number_gives_the_full_grid) {
  for (const Index g : {2U, 3U, 10U, 32U}) {
    const std::vector<Point> points = grid_points(g * g);
    for (Index row = 0; row < g; ++row) {
      for (Index column = 0; column < g; ++column) {
        EXPECT_EQ(points[row * g + column], (Point{static_cast<double>(column), static_cast<double>(row)}));
      }
    }
  }
}

TEST(Grid, other_numbers_cut_the_last_row_short) {
  EXPECT_EQ(grid_points(5), (std::vector<Point>{{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}}));
}

TEST(Grid, ceiling_square_roots_are_exact) {
  for (const Index g : {2U, 3U, 1000U, 46340U}) {
    EXPECT_EQ(ceiling_square_root(g * g - 1), g);
    EXPECT_EQ(ceiling_square_root(g * g), g);
    EXPECT_EQ(ceiling_square_root(g * g + 1), g + 1);
  }
}

TEST(Grid, an_exact_tilt_keeps_every_tie) {
  const std::vector<Point> points = generate("grid", 100, 1, {{"tilt", "exact"}});
  for (std::size_t i = 0; i + 11 < points.size(); ++i) {
    if (i % 10 > 7) continue;
    EXPECT_EQ(orientation(points[i], points[i + 1], points[i + 2]), 0);
    EXPECT_EQ(in_circle(points[i], points[i + 1], points[i + 11], points[i + 10]), 0);
    EXPECT_EQ(compare_length(points[i], points[i + 1], points[0], points[1]), 0);
  }
}

TEST(Grid, a_rounded_tilt_breaks_some_tie) {
  const std::vector<Point> points = generate("grid", 100, 1, {{"tilt", "rounded"}});
  int broken = 0;
  for (std::size_t i = 0; i + 2 < 10; ++i) broken += orientation(points[i], points[i + 1], points[i + 2]) != 0;
  EXPECT_GT(broken, 0);
  EXPECT_EQ(golden_hash("grid", 100, 1, {{"tilt", "rounded"}}), "a684f8b7461230bcb0b89ddadee49a21");
}

}  // namespace
}  // namespace mwt
