#include "algorithms/exact/holes/local_region.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/exact/testing/naive_candidates.h"

namespace mwt {
namespace {

TEST(LocalRegion, NumbersItsPointsInLexicographicOrder) {
  const std::vector<Point> points{{9, 9}, {2, 2}, {0, 2}, {2, 0}, {0, 0}, {1, 1}};
  FaceRegion region;
  region.vertices = {1, 2, 3, 4, 5};
  region.boundary = {{4, 3}, {3, 1}, {1, 2}, {2, 4}};
  region.candidates = {{1, 5}, {2, 5}, {3, 5}, {4, 5}};
  region.components = 2;
  const LocalRegion local = make_local(points, region);
  EXPECT_EQ(local.vertices, (std::vector<Index>{4, 2, 5, 3, 1}));
  EXPECT_EQ(local.points, (std::vector<Point>{{0, 0}, {0, 2}, {1, 1}, {2, 0}, {2, 2}}));
  EXPECT_EQ(local.boundary, (std::vector<Edge>{{0, 3}, {3, 4}, {4, 1}, {1, 0}}));
  ASSERT_EQ(local.sides.size(), local.boundary.size() + 2 * region.candidates.size());
  for (const Edge& edge : {Edge{4, 2}, Edge{2, 4}, Edge{0, 2}, Edge{0, 3}}) {
    EXPECT_NE(std::find(local.sides.begin(), local.sides.end(), edge), local.sides.end());
  }
  EXPECT_EQ(local.in_instance({{0, 3, 2}}), (std::vector<Triangle>{{4, 3, 5}}));
}

}  // namespace
}  // namespace mwt
