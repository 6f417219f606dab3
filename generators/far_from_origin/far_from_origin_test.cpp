#include "generators/far_from_origin/far_from_origin.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(FarFromOrigin, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("far_from_origin", 100, 1), "94e15c0bd896835660ddceaf59719d5c");
  EXPECT_EQ(golden_hash("far_from_origin", 100, 2), "60b1dddf4c15d27158fc42f70f3a42c6");
  EXPECT_EQ(golden_hash("far_from_origin", 100, 1, {{"offset", "-1e14"}}), "9ae9d85de4b8cf3ee1c7ed7255432461");
}

TEST(FarFromOrigin, points_lie_in_the_shifted_square) {
  for (const double offset : {1e6, -1e10, 0.}) {
    for (const Point& p : far_from_origin_points(100, 1, offset)) {
      EXPECT_TRUE(p.x >= offset && p.x <= offset + 1 && p.y >= offset && p.y <= offset + 1);
    }
  }
}

TEST(FarFromOrigin, what_rounding_merges_is_drawn_again) {
  const PointSet set = make_point_set(generate("far_from_origin", 4096, 1, {{"offset", "1e14"}}), "test");
  EXPECT_EQ(set.points.size(), 4096U) << "64 doubles per unit";
}

TEST(FarFromOrigin, n_is_limited_by_the_doubles_in_the_square) {
  EXPECT_EQ(max_far_from_origin(1e14), 4096U);
  EXPECT_EQ(max_far_from_origin(0x1p51), 4U);
  EXPECT_EQ(max_far_from_origin(0), std::uint64_t{1} << 62) << "more than anybody can ask for";
  EXPECT_NE(refusal("far_from_origin", 4097, {{"offset", "1e14"}}).find("nearest legal n is 4096"), std::string::npos);
  EXPECT_EQ(refusal("far_from_origin", 4, {{"offset", "2251799813685248"}}), "");
  EXPECT_NE(refusal("far_from_origin", 3, {{"offset", "1e16"}}).find("offset=1e+16"), std::string::npos);
}

}  // namespace
}  // namespace mwt
