#include "generators/clustered/clustered.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Clustered, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("clustered", 100, 1), "e274ae5497db338325818988df2b3822");
  EXPECT_EQ(golden_hash("clustered", 100, 2), "642b54f318eb4daf3a5e9bf9bd92a6cd");
  EXPECT_EQ(golden_hash("clustered", 100, 1, {{"shape", "isotropic"}}), "5a123006305273debb0ac1d397e14ff6");
  EXPECT_EQ(golden_hash("clustered", 100, 1, {{"clusters", "50"}, {"sigma", "0.01"}}),
            "bd573d9b137ebe262e2fdc6c2b7dafa3");
}

// Mean of (p - mean)(p - mean)': xx, xy, yy.
std::array<double, 3> covariance(const std::vector<Point>& points) {
  const auto n = static_cast<double>(points.size());
  Point mean;
  for (const Point& p : points) mean = {mean.x + p.x / n, mean.y + p.y / n};
  std::array<double, 3> sums{};
  for (const Point& p : points) {
    const double x = p.x - mean.x, y = p.y - mean.y;
    sums = {sums[0] + x * x / n, sums[1] + x * y / n, sums[2] + y * y / n};
  }
  return sums;
}

TEST(Clustered, an_isotropic_cluster_is_round_and_has_the_asked_width) {
  const auto [xx, xy, yy] = covariance(clustered_points(10'000, 3, 1, .01, ClusterShape::isotropic));
  EXPECT_NEAR(xx, 1e-4, 1e-5);
  EXPECT_NEAR(xy, 0, 1e-5);
  EXPECT_NEAR(yy, 1e-4, 1e-5);
}

TEST(Clustered, an_elliptic_cluster_has_axes_of_its_own_in_the_stated_range) {
  bool some_is_tilted = false;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto [xx, xy, yy] = covariance(clustered_points(10'000, seed, 1, 1, ClusterShape::elliptic));
    const double middle = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
    EXPECT_GT(std::sqrt(middle - radius), .24);
    EXPECT_LT(std::sqrt(middle + radius), 1.8);
    some_is_tilted = some_is_tilted || std::abs(xy) > .1;
  }
  EXPECT_TRUE(some_is_tilted);
}

TEST(Clustered, there_are_as_many_clusters_as_asked_for) {
  std::vector<Point> centres;  // of clusters much smaller than their distances
  for (const Point& p : clustered_points(1000, 4, 7, 1e-6, ClusterShape::elliptic)) {
    const bool known = std::any_of(centres.begin(), centres.end(),
                                   [&](const Point& c) { return std::hypot(p.x - c.x, p.y - c.y) < 1e-4; });
    if (!known) centres.push_back(p);
  }
  EXPECT_EQ(centres.size(), 7U);
}

TEST(Clustered, clusters_too_small_for_doubles_are_refused) {
  EXPECT_NE(refusal("clustered", 100, {{"sigma", "1e-40"}}).find("ended at 5"), std::string::npos);
  EXPECT_NE(refusal("clustered", 100, {{"sigma", "0"}}).find("sigma=0"), std::string::npos);
  EXPECT_NE(refusal("clustered", 100, {{"clusters", "0"}}).find("clusters=0"), std::string::npos);
}

}  // namespace
}  // namespace mwt
