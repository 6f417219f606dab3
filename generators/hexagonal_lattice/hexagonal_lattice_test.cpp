#include "generators/hexagonal_lattice/hexagonal_lattice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(HexagonalLattice, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("hexagonal_lattice", 100, 1), "e52ade7c0884cf1938479f2139569320");
}

TEST(HexagonalLattice, neighbours_are_at_distance_one_up_to_rounding) {
  const std::vector<Point> points = hexagonal_lattice_points(100);
  const auto distance = [&](std::size_t i, std::size_t j) {
    return std::hypot(points[i].x - points[j].x, points[i].y - points[j].y);
  };
  for (std::size_t row = 0; row + 1 < 10; ++row) {
    for (std::size_t column = 0; column + 1 < 10; ++column) {
      const std::size_t i = 10 * row + column, above = i + 10 + row % 2;
      EXPECT_EQ(distance(i, i + 1), 1);
      EXPECT_NEAR(distance(i, above), 1, 1e-14);
    }
  }
}

TEST(HexagonalLattice, rows_are_exactly_collinear) {
  const std::vector<Point> points = hexagonal_lattice_points(10'000);
  for (std::size_t i = 0; i + 2 < 100; ++i) {
    EXPECT_EQ(orientation(points[7700 + i], points[7701 + i], points[7702 + i]), 0);
  }
}

}  // namespace
}  // namespace mwt
