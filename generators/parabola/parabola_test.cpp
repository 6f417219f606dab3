#include "generators/parabola/parabola.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Parabola, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("parabola", 100, 1), "b1df40aa1a0cb4edd7dc92903a275bc0");
}

TEST(Parabola, points_are_exact_and_in_strictly_convex_position) {
  EXPECT_EQ(parabola_points(3), (std::vector<Point>{{0, 0}, {1, 1}, {2, 4}}));
  EXPECT_TRUE(is_in_strictly_convex_position(parabola_points(100'000)));
  const double last = kMaxParabola - 1;
  EXPECT_LE(last * last, 0x1p53);
  EXPECT_GT((last + 1) * (last + 1), 0x1p53);
}

TEST(Parabola, the_fan_from_the_first_point_is_delaunay) {
  const std::vector<Point> points = parabola_points(1000);
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    EXPECT_LT(in_circle(points[0], points[i], points[i + 1], points[i + 2]), 0);
  }
}

}  // namespace
}  // namespace mwt
