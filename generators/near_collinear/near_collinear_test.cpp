#include "generators/near_collinear/near_collinear.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(NearCollinear, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("near_collinear", 100, 1), "2ff2334274207fca5ad3d1be3e3c2855");
  EXPECT_EQ(golden_hash("near_collinear", 100, 2), "baba07f5ccb63cd032bd24411e830c01");
  EXPECT_EQ(golden_hash("near_collinear", 100, 1, {{"height", "1e-300"}}), "739b6840ae07db77457288d2c7d20e64");
}

TEST(NearCollinear, points_run_from_left_to_right_in_a_thin_strip) {
  const std::vector<Point> points = near_collinear_points(1000, 1, 1e-12);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(i == 0 || points[i].x - points[i - 1].x > .00049);
    EXPECT_TRUE(points[i].x >= 0 && points[i].x < 1);
    EXPECT_TRUE(points[i].y >= 0 && points[i].y < 1e-12);
  }
}

}  // namespace
}  // namespace mwt
