#include "algorithms/exact/candidates/near_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "generators/registry.h"

namespace mwt {
namespace {

TEST(NearPoints, AreScaledToTwoToTheSixtieth) {
  for (const double size : {0x1p-900, 0x1p-3, 1.0, 0x1p900}) {
    const std::vector<Point> points{{0, 0}, {size, 0}, {0, 0.5 * size}};
    EXPECT_EQ(size * distance_scale(make_kd_order(points)), 0x1p60);
  }
}

TEST(NearPoints, HaveALowerBoundOfTheBoxesDistance) {
  const Box a{0, 0, 1, 1}, right{4, 0, 5, 1}, corner{4, 5, 6, 7}, touching{1, 1, 2, 2};
  EXPECT_LE(box_distance(a, right, 1), 3);
  EXPECT_GT(box_distance(a, right, 1), 2.99999F);
  EXPECT_LE(box_distance(corner, a, 2), 10);
  EXPECT_GT(box_distance(corner, a, 2), 9.9999F);
  EXPECT_EQ(box_distance(a, touching, 1), 0);
}

// The leaf's own points come first, then whole leaves in order of distance, none of the others being nearer.
TEST(NearPoints, AreThoseOfTheClosestLeaves) {
  const KdOrder order = make_kd_order(generate("clustered", 2000, 1));
  NearPointsFinder finder(order);
  for (std::uint32_t leaf = order.leaf_count; leaf < 2 * order.leaf_count; leaf += 7) {
    const NearPoints& near = finder.find(leaf);
    ASSERT_EQ(near.leaves, NearPoints::kLeaves);
    ASSERT_EQ(near.leaf_size, static_cast<int>(order.last_of(leaf) - order.first_of(leaf)));
    for (Index i = 0; i < static_cast<Index>(near.leaf_size); ++i) {
      EXPECT_EQ((Point{near.x[i], near.y[i]}), order.points[order.first_of(leaf) + i]);
    }
    std::vector<float> distances;
    for (std::uint32_t other = order.leaf_count; other < 2 * order.leaf_count; ++other) {
      distances.push_back(other == leaf ? 0 : box_distance(order.boxes[leaf], order.boxes[other], near.scale));
    }
    std::sort(distances.begin(), distances.end());
    EXPECT_TRUE(std::equal(near.distance.begin(), near.distance.end(), distances.begin()));
  }
}

TEST(NearPoints, TakeSamplesFromEverywhere) {
  const KdOrder order = make_kd_order(generate("uniform", 2000, 1));
  NearPointsFinder finder(order);
  const int places = finder.find(order.leaf_count).places();
  const NearPoints& near = finder.add_samples(order.leaf_count);
  EXPECT_EQ(near.places(), places + near.samples);
  double farthest = 0;
  for (auto i = static_cast<std::size_t>(places); i < static_cast<std::size_t>(near.places()); ++i) {
    EXPECT_NE(std::find(order.points.begin(), order.points.end(), Point{near.x[i], near.y[i]}), order.points.end());
    farthest = std::max(farthest, std::hypot(near.x[i] - near.x[0], near.y[i] - near.y[0]));
  }
  EXPECT_GT(farthest, 0.7) << "the first leaf lies in a corner of the unit square";
}

}  // namespace
}  // namespace mwt
