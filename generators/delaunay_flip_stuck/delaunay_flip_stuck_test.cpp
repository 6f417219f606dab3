#include "generators/delaunay_flip_stuck/delaunay_flip_stuck.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(DelaunayFlipStuck, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("delaunay_flip_stuck", 100, 1), "5b5aabef9d7ab8dce3732551d6dce94b");
}

TEST(DelaunayFlipStuck, the_arc_is_strictly_convex_up_to_the_largest_n) {
  for (const Index n : {6U, 7U, 100U, 4096U, kMaxDelaunayFlipStuck}) {
    const std::vector<Point> points = delaunay_flip_stuck_points(n);
    ASSERT_EQ(points.size(), n);
    EXPECT_TRUE(turns_everywhere({points.begin(), points.end() - 3}, -1)) << n;
  }
}

// v w_1 is Delaunay: a circle through v, w_1 and w_2 leaves out w_0 and all p_i. It cuts the p_i off from w_0.
TEST(DelaunayFlipStuck, the_circle_that_hides_w_0_is_empty) {
  for (const Index n : {6U, 16U, 100U, 4096U, kMaxDelaunayFlipStuck}) {
    const std::vector<Point> points = delaunay_flip_stuck_points(n);
    const Point &v = points[n - 4], &w_0 = points[n - 3], &w_1 = points[n - 2], &w_2 = points[n - 1];
    ASSERT_GT(orientation(v, w_1, w_2) * orientation(v, w_0, w_1), 0);
    const int turn = orientation(v, w_1, w_2);
    EXPECT_LT(turn * in_circle(v, w_1, w_2, w_0), 0);
    EXPECT_LT(turn * in_circle(v, w_1, w_2, points[n - 5]), 0);
    EXPECT_LT(turn * in_circle(v, w_1, w_2, points[0]), 0);
    for (Index i = 0; i + 5 < n; i += 1 + n / 100) EXPECT_TRUE(segments_cross(v, w_1, points[i], w_0));
  }
}

}  // namespace
}  // namespace mwt
