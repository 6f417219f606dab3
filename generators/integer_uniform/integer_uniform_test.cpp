#include "generators/integer_uniform/integer_uniform.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(IntegerUniform, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("integer_uniform", 100, 1), "3f404907906628cf405a1fd111902c45");
  EXPECT_EQ(golden_hash("integer_uniform", 100, 2), "741308a8fe68b1dd67ec264075f04ebf");
  EXPECT_EQ(golden_hash("integer_uniform", 100, 1, {{"range", "1000"}}), "b7580e49a1a729ef299f4ec9776fbf55");
}

TEST(IntegerUniform, coordinates_are_integers_in_range) {
  for (const Point& p : integer_uniform_points(200, 1, 20)) {
    EXPECT_TRUE(p.x == std::floor(p.x) && p.x >= 0 && p.x < 20);
    EXPECT_TRUE(p.y == std::floor(p.y) && p.y >= 0 && p.y < 20);
  }
}

TEST(IntegerUniform, can_take_every_point_of_the_range) {
  const PointSet set = make_point_set(generate("integer_uniform", 2500, 1, {{"range", "50"}}), "test");
  EXPECT_EQ(set.points.size(), 2500U);
}

TEST(IntegerUniform, a_range_that_is_too_small_is_refused) {
  EXPECT_NE(refusal("integer_uniform", 26, {{"range", "5"}}).find("nearest legal n is 25"), std::string::npos);
  EXPECT_NE(refusal("integer_uniform", 3, {{"range", "1"}}).find("range=1"), std::string::npos);
  EXPECT_NE(refusal("integer_uniform", 3, {{"range", "-3"}}).find("range=-3"), std::string::npos);
}

}  // namespace
}  // namespace mwt
