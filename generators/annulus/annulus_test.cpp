#include "generators/annulus/annulus.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Annulus, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("annulus", 100, 1), "4fb596420129cb57ee937eee9a090006");
  EXPECT_EQ(golden_hash("annulus", 100, 2, {{"inner", "0"}}), "507a99d94e757ebc1f69d72e49a9e1eb");
}

TEST(Annulus, points_are_uniform_by_area) {
  int outer_half = 0;
  for (const Point& p : annulus_points(8000, 1, .6)) {
    const double squared = p.x * p.x + p.y * p.y;
    EXPECT_GE(squared, .36 * (1 - 1e-12));
    EXPECT_LE(squared, 1 + 1e-12);
    outer_half += squared > .68;
  }
  EXPECT_NEAR(outer_half, 4000, 250);
}

}  // namespace
}  // namespace mwt
