#include "generators/cluster_in_triangle/cluster_in_triangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(ClusterInTriangle, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("cluster_in_triangle", 100, 1), "adea32fde6e57fb4fa955840825a97b9");
  EXPECT_EQ(golden_hash("cluster_in_triangle", 100, 2, {{"side", "1"}}), "7d4867e3d8786d6b0942bea86eb8a71c");
}

TEST(ClusterInTriangle, the_cluster_is_small_and_in_the_middle_of_the_hull) {
  const std::vector<Point> points = cluster_in_triangle_points(1000, 1, .01);
  EXPECT_EQ(convex_hull(points).size(), 3U);
  for (std::size_t i = 3; i < points.size(); ++i) {
    EXPECT_LE(std::abs(points[i].x), .005);
    EXPECT_LE(std::abs(points[i].y), .005);
  }
}

TEST(ClusterInTriangle, points_too_near_to_each_other_for_doubles_are_refused) {
  EXPECT_NE(refusal("cluster_in_triangle", 100, {{"side", "0"}}).find("side=0"), std::string::npos);
}

}  // namespace
}  // namespace mwt
