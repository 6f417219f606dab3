#include "harness/explore/server/kept_points.h"

#include <gtest/gtest.h>

#include "harness/explore/frame.h"

namespace mwt {
namespace {

std::string points_at(double x) { return bytes_of(std::vector<Point>{{x, 0}, {x, 1}}); }

TEST(KeptPoints, AreFoundByTheirNameUntilTheyDoNotFit) {
  KeptPoints kept(3 * points_at(0).size());
  const std::string first = kept.keep(points_at(1)).value();
  const std::string second = kept.keep(points_at(2)).value();
  EXPECT_NE(first, second);
  EXPECT_EQ(kept.keep(points_at(1)), first);
  EXPECT_EQ(*kept.find(second), points_at(2));
  const std::string third = kept.keep(points_at(3)).value();
  EXPECT_TRUE(kept.find(first));
  EXPECT_TRUE(kept.keep(points_at(4)));
  EXPECT_FALSE(kept.find(second)) << "used longest ago";
  EXPECT_TRUE(kept.find(first));
  EXPECT_TRUE(kept.find(third));
}

TEST(KeptPoints, ThatAreNoneAreRefused) {
  KeptPoints kept(100);
  EXPECT_FALSE(kept.keep(""));
  EXPECT_FALSE(kept.keep("odd"));
  EXPECT_FALSE(kept.keep(std::string(112, '\0'))) << "too many";
  EXPECT_FALSE(kept.find("none"));
}

}  // namespace
}  // namespace mwt
