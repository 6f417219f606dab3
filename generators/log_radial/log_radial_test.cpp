#include "generators/log_radial/log_radial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(LogRadial, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("log_radial", 100, 1), "41837f4c0f8af5be21f13f6033ad31cc");
  EXPECT_EQ(golden_hash("log_radial", 100, 2, {{"octaves", "100"}}), "2288e0814f79eb3c9ed4ba533ac41e99");
}

TEST(LogRadial, every_octave_has_its_share) {
  constexpr Index kN = 8000;
  std::array<int, 8> found{};
  for (const Point& p : log_radial_points(kN, 1, 8)) {
    const double distance = std::hypot(p.x, p.y);
    EXPECT_LT(distance, 1.0000001);
    ++found[static_cast<std::size_t>(std::clamp(-std::ilogb(distance) - 1, 0, 7))];
  }
  for (const int count : found) EXPECT_NEAR(count, kN / 8, 5 * std::sqrt(kN / 8.));
}

TEST(LogRadial, directions_are_even) {
  int right = 0, upper = 0;
  for (const Point& p : log_radial_points(8000, 1, 20)) {
    right += p.x > 0;
    upper += p.y > 0;
  }
  EXPECT_NEAR(right, 4000, 250);
  EXPECT_NEAR(upper, 4000, 250);
}

}  // namespace
}  // namespace mwt
