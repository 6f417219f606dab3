#include "generators/insertion_trap/insertion_trap.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(InsertionTrap, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("insertion_trap", 100, 1), "fbd73de9bfc0e2dc689e88312cb083f8");
}

TEST(InsertionTrap, the_tiny_polygon_is_strictly_convex_and_so_holds_no_point_of_its_triangles) {
  for (const Index n : {9U, 100U, 4096U, 100'000U}) {
    const std::vector<Point> points = insertion_trap_points(n);
    ASSERT_EQ(points.size(), n);
    EXPECT_TRUE(is_in_strictly_convex_position({points.begin() + 3, points.end() - 3}));
  }
}

TEST(InsertionTrap, triangles_are_nested) {
  const std::vector<Point> points = insertion_trap_points(1000);
  EXPECT_EQ(convex_hull(points).size(), 3U);
  const auto holds = [&](std::size_t corner, std::size_t i) {
    return in_closed_triangle(points[i], points[corner], points[corner + 1], points[corner + 2]);
  };
  for (std::size_t i = 3; i < 1000; ++i) EXPECT_TRUE(holds(0, i));
  for (std::size_t i = 3; i < 997; ++i) EXPECT_TRUE(holds(997, i));
}

}  // namespace
}  // namespace mwt
