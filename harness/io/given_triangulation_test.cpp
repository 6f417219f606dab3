#include "harness/io/given_triangulation.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

const std::vector<Point> kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}};  // the last repeats the second

std::string rule(const std::vector<Triangle>& triangles) {
  return broken_rule(make_point_set(kSquare, "square"), kSquare, GivenSolution{triangles, {}, false}).value_or("");
}

TEST(GivenTriangulation, CornersMayBeDuplicates) { EXPECT_EQ(rule({{0, 4, 2}, {0, 2, 3}}), ""); }

TEST(GivenTriangulation, ACornerOutOfRangeIsNamedAsTheFileHasIt) {
  EXPECT_EQ(rule({{0, 1, 2}, {0, 2, 7}}), "indices_in_range: triangle 1 has corner 7, but points go from 0 to 4");
  EXPECT_EQ(rule({{1, 2, 3}, {1, 3, 5}}), "indices_in_range: triangle 1 has corner 5, but points go from 0 to 4");
  EXPECT_EQ(rule({{0, 1, 2}, {1, 3, 5}}), "indices_in_range: triangle 1 has corner 5, but points go from 0 to 4");
}

TEST(GivenTriangulation, OtherRulesAreNamedByTheChecker) {
  EXPECT_TRUE(rule({{0, 2, 1}, {0, 2, 3}}).starts_with("strictly_counter_clockwise: triangle 0"));
  EXPECT_TRUE(rule({{0, 1, 2}}).ends_with(" (points numbered without the duplicates)"));
}

}  // namespace
}  // namespace mwt
