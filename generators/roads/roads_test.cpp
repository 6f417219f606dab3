#include "generators/roads/roads.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Roads, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("roads", 100, 1), "752d2a927536556075929b9c6cc24d0b");
  EXPECT_EQ(golden_hash("roads", 100, 2, {{"roads", "3"}}), "4b75c5861b6cafefc5a4342146a1d752");
}

// One road has ten legs: nearly all triples of one leg are as flat as rounding allows.
TEST(Roads, points_lie_on_few_lines) {
  const std::vector<Point> points = roads_points(60, 1, 1);
  std::size_t flat = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const Point &a = points[i], &b = points[j], &c = points[k];
        flat += std::abs((a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x)) < 1e-15;
      }
    }
  }
  EXPECT_GT(flat, 10U * 10) << "ten legs with about C(6, 3) triples each";
}

TEST(Roads, a_road_is_as_long_as_its_legs) {
  const std::vector<Point> points = roads_points(1000, 5, 1);
  for (const Point& p : points) EXPECT_LE(std::hypot(p.x - points[0].x, p.y - points[0].y), 1.0000001);
}

}  // namespace
}  // namespace mwt
