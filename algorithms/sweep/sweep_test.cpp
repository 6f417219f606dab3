#include "algorithms/sweep/sweep.h"

#include "algorithms/common/testing/instances.h"
#include "geometry/weight.h"

namespace mwt {
namespace {

TEST(Sweep, IsValidOnAllShapes) { test::expect_valid_on_all_shapes(sweep_entry(), 1000); }

TEST(Sweep, JoinsTheFirstPointOffALineToTheWholeLine) {
  const std::vector<Point> points = {{0, 0}, {0, 1}, {0, 2}, {1, 0}};
  const std::vector<Triangle> expected = {{1, 0, 3}, {2, 1, 3}};
  EXPECT_EQ(sweep_triangulation(points).triangles, expected);
}

TEST(Sweep, ListsTrianglesByTheirLastPointCounterClockwiseFirst) {
  //   1   3
  // 0       4
  //   2
  const std::vector<Point> points = {{0, 0}, {1, 1}, {1, -1}, {2, 1}, {3, 0}};
  // Lexicographic order 0, 2, 1, 3, 4. Point 3 sees 21 from 1 backwards; 4 sees 23 from 3 backwards.
  const std::vector<Triangle> expected = {{0, 2, 1}, {1, 2, 3}, {3, 2, 4}};
  EXPECT_EQ(sweep_triangulation(points).triangles, expected);
}

TEST(Sweep, EdgesInLineWithTheNewPointAreNotSeen) {
  const std::vector<Point> points = {{0, 0}, {1, 0}, {1, 1}, {2, 0}, {3, 0}};
  const Triangulation triangulation = sweep_triangulation(points);
  EXPECT_FALSE(find_violation(points, triangulation).has_value());
  const std::vector<Edge> edges = edges_of(triangulation);
  EXPECT_EQ(std::count(edges.begin(), edges.end(), make_edge(0, 3)), 0);
  EXPECT_EQ(std::count(edges.begin(), edges.end(), make_edge(1, 4)), 0);
}

TEST(Sweep, WeighsAboutTheSquareRootOfNTimesTooMuch) {
  const std::vector<Point> points = test::uniform_points(1024, 3);
  const double per_point = weight(points, sweep_triangulation(points)).lower / std::sqrt(1024.0);
  EXPECT_GT(per_point, 3 * 3.7);  // a minimum weight triangulation has about 3.7
}

}  // namespace
}  // namespace mwt
