#include "algorithms/brute_force/brute_force.h"

#include <algorithm>

#include "algorithms/common/testing/solver_testing.h"

namespace mwt {
namespace {

// A convex polygon with integer corners.
std::vector<Point> parabola(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) points.push_back({static_cast<double>(i), static_cast<double>(i * i)});
  return points;
}

TEST(BruteForce, TakesTheShorterDiagonal) {
  const std::vector<Point> points = {{0, 0}, {4, 1}, {4, 3}, {0, 2}};
  const BruteForceResult result = enumerate_triangulations(points, Context());
  EXPECT_EQ(result.count, 2U);
  EXPECT_EQ(canonical_triangles(result.lightest), (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(BruteForce, NeverPutsAnEdgeThroughAPoint) {
  const std::vector<Point> points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};  // the centre of a square
  const BruteForceResult result = enumerate_triangulations(points, Context());
  EXPECT_FALSE(find_violation(points, result.lightest));
  EXPECT_EQ(result.count, 1U);
}

TEST(BruteForce, CountsTheThreeByThreeGrid) {
  std::vector<Point> points;
  for (int i = 0; i < 9; ++i) points.push_back({static_cast<double>(i % 3), static_cast<double>(i / 3)});
  EXPECT_EQ(enumerate_triangulations(points, Context()).count, 64U);
}

TEST(BruteForce, DoesNotDependOnTheOrderOfPoints) {
  std::vector<Point> points = parabola(8);
  points.push_back({3, 20});
  points.push_back({4, 21});
  const BruteForceResult forwards = enumerate_triangulations(points, Context());
  std::reverse(points.begin(), points.end());
  const BruteForceResult backwards = enumerate_triangulations(points, Context());
  EXPECT_EQ(forwards.count, backwards.count);
  EXPECT_TRUE(overlap(forwards.optimum, backwards.optimum));
}

TEST(BruteForce, StopsWithTheFirstTriangulationWhenItIsLate) {
  Context late;
  late.deadline = Context::Clock::now();
  const BruteForceResult result = enumerate_triangulations(parabola(10), late);
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.count, 1U);
  EXPECT_FALSE(find_violation(parabola(10), result.lightest));
}

TEST(BruteForce, CountsFourteenPointsInConvexPosition) {
  const BruteForceResult result = enumerate_triangulations(parabola(14), Context());
  EXPECT_EQ(result.count, 208012U);  // the Catalan number C(12)
}

}  // namespace
}  // namespace mwt
