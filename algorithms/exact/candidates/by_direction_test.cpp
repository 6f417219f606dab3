#include "algorithms/exact/candidates/by_direction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace mwt {
namespace {

std::vector<Index> sorted_around(Points points, Index center) {
  std::vector<Index> others(points.size());
  std::iota(others.begin(), others.end(), Index{0});
  std::erase(others, center);
  std::sort(others.begin(), others.end(), ByDirection(points, center));
  return others;
}

TEST(ByDirection, GoesCounterClockwiseFromThePositiveXAxis) {
  const std::vector<Point> points{{0, 0}, {1, -1}, {0, -2}, {-1, -1}, {-3, 0}, {-1, 1}, {0, 1}, {2, 2}, {5, 0}};
  EXPECT_EQ(sorted_around(points, 0), (std::vector<Index>{8, 7, 6, 5, 4, 3, 2, 1}));
}

TEST(ByDirection, PutsTheNearerOfOneDirectionFirst) {
  const std::vector<Point> points{{1, 1}, {4, 4}, {2, 2}, {0, 0}, {-1, -1}, {3, 3}};
  EXPECT_EQ(sorted_around(points, 0), (std::vector<Index>{2, 5, 1, 3, 4}));
  const ByDirection by_direction(points, 0);
  EXPECT_TRUE(by_direction.is_same_direction(1, 5));
  EXPECT_FALSE(by_direction.is_same_direction(1, 3)) << "opposite directions";
}

// One step of doubles beside the diagonal: rounded angles are equal.
TEST(ByDirection, SeparatesDirectionsThatDoublesDoNot) {
  const double step = 1 + 0x1p-52;
  const std::vector<Point> points{{0, 0}, {1, step}, {1, 1}, {step, 1}};
  EXPECT_EQ(sorted_around(points, 0), (std::vector<Index>{3, 2, 1}));
  EXPECT_FALSE(ByDirection(points, 0).is_same_direction(1, 2));
}

}  // namespace
}  // namespace mwt
