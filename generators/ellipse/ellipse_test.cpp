#include "generators/ellipse/ellipse.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Ellipse, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("ellipse", 100, 1), "e215683d64d3b3be0dda67ac61f58d3a");
  EXPECT_EQ(golden_hash("ellipse", 100, 1, {{"aspect", "0.999"}}), "e29e4c8148936eb8122de593f697f0bc");
}

TEST(Ellipse, points_are_in_strictly_convex_position) {
  for (const double aspect : {1e-6, .3, .999, 1.0}) {
    for (const Index n : {3U, 4U, 5U, 100U, 65536U}) {
      EXPECT_TRUE(is_in_strictly_convex_position(ellipse_points(n, aspect))) << n << ' ' << aspect;
    }
  }
}

TEST(EllipseSlow, points_are_in_strictly_convex_position_at_the_largest_n) {
  EXPECT_TRUE(is_in_strictly_convex_position(ellipse_points(kMaxEllipse, .3)));
}

// The vertices that the zigzag visits: 0, -1, 1, -2, 2, .. from the rightmost on.
std::vector<Point> zigzag(Index n, double aspect) {
  const std::vector<Point> points = ellipse_points(n, aspect);
  std::vector<Point> path;
  for (Index i = 0; path.size() < n; ++i) {
    path.push_back(points[i]);
    if (path.size() < n) path.push_back(points[n - 1 - i]);
  }
  return path;
}

// Consecutive vertices of the zigzag are its triangles; two of them form the quadrilateral path[i] .. path[i + 3] with
// the diagonal path[i + 1] path[i + 2], turning right at even i.
TEST(Ellipse, the_zigzag_is_delaunay_and_a_local_optimum_of_flips) {
  for (const double aspect : {.3, .9, .999}) {
    for (const Index n : {5U, 16U, 101U, 4096U}) {
      const std::vector<Point> path = zigzag(n, aspect);
      for (std::size_t i = 0; i + 3 < path.size(); ++i) {
        const int turn = orientation(path[i], path[i + 1], path[i + 2]);
        EXPECT_EQ(turn, i % 2 == 0 ? -1 : 1);
        EXPECT_LT(turn * in_circle(path[i], path[i + 1], path[i + 2], path[i + 3]), 0) << n << ' ' << i;
        const bool can_flip =
            is_strictly_convex(path[i], path[turn > 0 ? i + 1 : i + 2], path[i + 3], path[turn > 0 ? i + 2 : i + 1]);
        const bool improves = compare_length(path[i], path[i + 3], path[i + 1], path[i + 2]) < 0;
        EXPECT_FALSE(can_flip && improves) << n << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace mwt
