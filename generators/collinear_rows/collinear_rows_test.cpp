#include "generators/collinear_rows/collinear_rows.h"

#include <gtest/gtest.h>

#include "generators/testing.h"
#include "geometry/convex_hull.h"

namespace mwt {
namespace {

TEST(CollinearRows, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("collinear_rows", 100, 1), "97152103ac10ac4dbb3ea0ba47cb9dce");
  EXPECT_EQ(golden_hash("collinear_rows", 100, 1, {{"rows", "3"}, {"gap", "0.1"}}), "49a2ce26ce4663e4d61290de0bced161");
}

TEST(CollinearRows, column_after_column) {
  EXPECT_EQ(collinear_rows(5, 2, .5), (std::vector<Point>{{0, 0}, {0, .5}, {1, 0}, {1, .5}, {2, 0}}));
}

TEST(CollinearRows, two_rows_lie_on_the_hull_entirely) {
  for (const Index n : {4U, 10U, 101U}) EXPECT_EQ(convex_hull(collinear_rows(n, 2, .1)).size(), n);
}

TEST(CollinearRows, too_few_points_or_rows_are_refused) {
  EXPECT_NE(refusal("collinear_rows", 5, {{"rows", "5"}}).find("nearest legal n is 6"), std::string::npos);
  EXPECT_EQ(refusal("collinear_rows", 6, {{"rows", "5"}}), "");
  EXPECT_NE(refusal("collinear_rows", 5, {{"rows", "1"}}).find("rows=1"), std::string::npos);
  EXPECT_NE(refusal("collinear_rows", 5, {{"gap", "0"}}).find("gap=0"), std::string::npos);
}

}  // namespace
}  // namespace mwt
