#include "algorithms/subset_dp/subset_dp.h"

#include <cmath>

#include "algorithms/common/testing/solver_testing.h"
#include "generators/registry.h"

namespace mwt {
namespace {

SubsetDpResult solve(Points points) {
  std::optional<StopReason> stop_reason;
  return count_and_optimise(points, Context(), stop_reason).value();
}

std::vector<Point> grid(int width, int height) {
  std::vector<Point> points;
  for (int i = 0; i < width * height; ++i) {
    points.push_back({static_cast<double>(i % width), static_cast<double>(i / width)});
  }
  return points;
}

TEST(SubsetDp, HasOneWayThroughATriangle) {
  const std::vector<Point> points = {{0, 0}, {1, 0}, {0, 1}};
  const SubsetDpResult result = solve(points);
  EXPECT_EQ(result.count, "1");
  EXPECT_EQ(canonical_triangles(result.lightest), (std::vector<Triangle>{{0, 1, 2}}));
}

// V. Kaibel, G. M. Ziegler, "Counting lattice triangulations" (2003): 6, 64, 4 x 4: 46456 in squares of side 1, 2, 3
// the numbers 2, 64, 46456.
TEST(SubsetDp, CountsLatticeTriangulations) {
  EXPECT_EQ(solve(grid(2, 2)).count, "2");
  EXPECT_EQ(solve(grid(3, 2)).count, "6");
  EXPECT_EQ(solve(grid(3, 3)).count, "64");
  EXPECT_EQ(solve(grid(4, 4)).count, "46456");
}

TEST(SubsetDp, CountsCatalanNumbersBeyondEnumeration) {
  std::vector<Point> points;
  for (int i = 0; i < 18; ++i) points.push_back({static_cast<double>(i), static_cast<double>(i * i)});
  EXPECT_EQ(solve(points).count, "35357670");
}

// Two rows of 10 points: 18 triangles from left to right, of which 9 stand on the lower row; 18 over 9 orders.
TEST(SubsetDp, CountsStrips) {
  const SubsetDpResult result = solve(grid(10, 2));
  EXPECT_EQ(result.count, "48620");
  EXPECT_NEAR(result.optimum.middle(), 18 + 10 + 9 * std::sqrt(2.0), 1e-12);
}

TEST(SubsetDp, TreatsVerticalLinesLikeOthers) {
  std::vector<Point> points = grid(3, 4);
  const SubsetDpResult upright = solve(points);
  for (Point& p : points) p = {p.y, -p.x};
  const SubsetDpResult turned = solve(points);
  EXPECT_EQ(upright.count, turned.count);
  EXPECT_TRUE(overlap(upright.optimum, turned.optimum));
}

TEST(SubsetDp, GivesUpWhenItIsLate) {
  Context late;
  late.deadline = Context::Clock::now();
  std::optional<StopReason> stop_reason;
  EXPECT_FALSE(count_and_optimise(grid(4, 4), late, stop_reason));
  EXPECT_EQ(stop_reason, StopReason::deadline);
}

TEST(SubsetDpSlow, CountsTwentyTwoPoints) {
  const std::vector<Point> points = generate("uniform", 22, 1);
  const Solution counted = solve_to_optimality("subset_dp", points);
  EXPECT_TRUE(overlap(*counted.optimum, *solve_to_optimality("triangle_lp", points).optimum));
}

}  // namespace
}  // namespace mwt
