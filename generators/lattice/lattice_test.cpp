#include "generators/lattice/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "generators/grid/grid.h"
#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Lattice, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("lattice", 100, 1), "249446f1c9bbf1f92ca35b6e39de9e4c");
  EXPECT_EQ(golden_hash("lattice", 100, 2), "6014506dc49e525dbac92f7c8af55ed1");
  EXPECT_EQ(golden_hash("lattice", 100, 1, {{"holes", "0.5"}}), "72e0673cbdac4d30880dd2368be9a9ac");
}

TEST(Lattice, leaves_the_asked_share_out) {
  const std::vector<Point> points = lattice_points(900, 1, .1);  // 900 of ceil(sqrt(1000))^2 = 32 * 32
  for (const Point& p : points) {
    EXPECT_TRUE(p.x == std::floor(p.x) && p.x >= 0 && p.x < 32);
    EXPECT_TRUE(p.y == std::floor(p.y) && p.y >= 0 && p.y < 32);
  }
  EXPECT_TRUE(std::is_sorted(points.begin(), points.end(),
                             [](const Point& a, const Point& b) { return a.y < b.y || (a.y == b.y && a.x < b.x); }));
}

TEST(Lattice, without_holes_a_square_number_gives_the_grid) { EXPECT_EQ(lattice_points(100, 1, 0), grid_points(100)); }

TEST(Lattice, every_point_is_left_out_equally_often) {
  constexpr int kRounds = 4000;
  std::array<int, 9> kept{};
  for (int seed = 0; seed < kRounds; ++seed) {
    for (const Point& p : lattice_points(5, static_cast<std::uint64_t>(seed), .4)) {  // 5 of 3 * 3
      ++kept[static_cast<std::size_t>(3 * p.y + p.x)];
    }
  }
  for (const int count : kept) EXPECT_NEAR(count, kRounds * 5. / 9, 5 * std::sqrt(kRounds * 20. / 81));
}

}  // namespace
}  // namespace mwt
