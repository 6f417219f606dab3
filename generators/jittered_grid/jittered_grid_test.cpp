#include "generators/jittered_grid/jittered_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/grid/grid.h"
#include "generators/testing.h"

namespace mwt {
namespace {

TEST(JitteredGrid, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("jittered_grid", 100, 1), "222783d94b14bf598f6895cf75ac1881");
  EXPECT_EQ(golden_hash("jittered_grid", 100, 2), "ac4a80c4c961b9537af0fadeabb7c931");
}

TEST(JitteredGrid, points_stay_near_their_grid_points) {
  const std::vector<Point> grid = grid_points(1000);
  const std::vector<Point> points = jittered_grid_points(1000, 1, .25);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    EXPECT_LE(std::abs(points[i].x - grid[i].x), .125);
    EXPECT_LE(std::abs(points[i].y - grid[i].y), .125);
    EXPECT_NE(points[i], grid[i]);
  }
}

TEST(JitteredGrid, no_jitter_gives_the_grid) { EXPECT_EQ(jittered_grid_points(100, 1, 0), grid_points(100)); }

TEST(JitteredGrid, negative_jitter_is_refused) {
  EXPECT_NE(refusal("jittered_grid", 10, {{"jitter", "-1"}}).find("jitter=-1"), std::string::npos);
}

}  // namespace
}  // namespace mwt
