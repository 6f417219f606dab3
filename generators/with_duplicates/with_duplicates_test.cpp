#include "generators/with_duplicates/with_duplicates.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(WithDuplicates, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("with_duplicates", 100, 1), "81c23fa122becd41d35dc3d274ff3f3e");
  EXPECT_EQ(golden_hash("with_duplicates", 100, 2), "086868513104d0910be2bc0f73b5201e");
}

TEST(WithDuplicates, repeats_the_asked_share) {
  const auto duplicates = [](Index n, double share) {
    return make_point_set(points_with_duplicates(n, 1, share), "test").duplicates();
  };
  EXPECT_EQ(duplicates(1000, .25), 250U);
  EXPECT_EQ(duplicates(1000, 0), 0U);
  EXPECT_EQ(duplicates(1000, .999999), 997U);
  EXPECT_EQ(duplicates(10, .2), 2U);
  EXPECT_EQ(duplicates(3, .9), 0U);
}

TEST(WithDuplicates, a_share_of_everything_is_refused) {
  EXPECT_NE(refusal("with_duplicates", 10, {{"share", "1"}}).find("share=1"), std::string::npos);
}

}  // namespace
}  // namespace mwt
