#include "generators/unit_circle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mwt {
namespace {

TEST(UnitCircle, multiples_of_45_degrees_are_exact) {
  const double diagonal = 0x1.6a09e667f3bcdp-1;  // sqrt(1/2), correctly rounded
  const std::vector<Point> expected = {{1, 0},  {diagonal, diagonal},   {0, 1},  {-diagonal, diagonal},
                                       {-1, 0}, {-diagonal, -diagonal}, {0, -1}, {diagonal, -diagonal}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(unit_circle_point(i, 8), expected[i]);
    EXPECT_EQ(unit_circle_point(125 * i, 1000), expected[i]);
  }
}

TEST(UnitCircle, agrees_with_the_mathematics_library_to_an_ulp_or_two) {
  for (const std::uint64_t denominator : {3U, 7U, 100U, 1023U}) {
    for (std::uint64_t i = 0; i < denominator; ++i) {
      const long double angle = 2 * 3.14159265358979323846264338L * static_cast<long double>(i) / denominator;
      const Point p = unit_circle_point(i, denominator);
      EXPECT_NEAR(p.x, static_cast<double>(std::cos(angle)), 0x1p-53);
      EXPECT_NEAR(p.y, static_cast<double>(std::sin(angle)), 0x1p-53);
    }
  }
}

TEST(UnitCircle, is_symmetric) {
  constexpr std::uint64_t kCount = 2 * 3 * 4 * 101;
  for (std::uint64_t i = 1; i < kCount / 2; ++i) {
    const Point p = unit_circle_point(i, kCount);
    EXPECT_EQ(unit_circle_point(i + kCount / 2, kCount), (Point{-p.x, -p.y}));
    EXPECT_EQ(unit_circle_point(kCount - i, kCount), (Point{p.x, -p.y}));
  }
}

TEST(UnitCircle, takes_angles_of_53_bits) {
  constexpr std::uint64_t kTurn = std::uint64_t{1} << 53;
  const Point p = unit_circle_point(kTurn - 1, kTurn);
  EXPECT_EQ(p.x, 1);
  EXPECT_NEAR(p.y, -2 * 3.14159265358979324 / 0x1p53, 1e-31);
}

}  // namespace
}  // namespace mwt
