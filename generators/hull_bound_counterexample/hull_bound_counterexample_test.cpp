#include "generators/hull_bound_counterexample/hull_bound_counterexample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "generators/testing.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

TEST(HullBoundCounterexample, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("hull_bound_counterexample", 13, 1), "1ef5f65781ce002917db253474f9f380");
}

TEST(HullBoundCounterexample, the_last_point_is_the_only_inner_one) {
  const std::vector<Point> points = hull_bound_counterexample_points();
  EXPECT_EQ(points.back(), (Point{0, 0}));
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_GT(orientation(points[i], points[(i + 1) % 12], points[(i + 2) % 12]), 0) << "convex, counter-clockwise";
    EXPECT_GT(orientation(points[i], points[(i + 1) % 12], points.back()), 0);
  }
}

TEST(HullBoundCounterexample, the_spokes_are_lighter_than_the_best_diagonals) {
  const std::vector<Point> points = hull_bound_counterexample_points();
  const auto distance = [&](std::size_t i, std::size_t j) {
    return std::hypot(points[i].x - points[j].x, points[i].y - points[j].y);
  };
  // best[i][j]: least total of the diagonals inside the polygon i .. j, its side (i, j) counted if it is a diagonal.
  std::array<std::array<double, 12>, 12> best{};
  double spokes = 0;
  for (std::size_t i = 0; i < 12; ++i) spokes += distance(i, 12);
  for (std::size_t span = 2; span < 12; ++span) {
    for (std::size_t i = 0; i + span < 12; ++i) {
      double least = 1e9;
      for (std::size_t k = i + 1; k < i + span; ++k) least = std::min(least, best[i][k] + best[k][i + span]);
      best[i][i + span] = least + (span < 11 ? distance(i, i + span) : 0);
    }
  }
  EXPECT_NEAR(best[0][11], 493.7304, .00005);
  EXPECT_NEAR(spokes, 491.7044, .00005);
}

}  // namespace
}  // namespace mwt
