#include "algorithms/quadtree/quadtree.h"

#include <numeric>

#include "algorithms/common/testing/instances.h"
#include "algorithms/quadtree/leaf_triangulation.h"
#include "base/error.h"
#include "geometry/delaunay.h"
#include "geometry/mesh/flip_triangulation.h"
#include "geometry/quadtree.h"
#include "geometry/weight.h"

namespace mwt {
namespace {

std::vector<Index> all_of(Points points) {
  std::vector<Index> indices(points.size());
  std::iota(indices.begin(), indices.end(), Index{0});
  return indices;
}

double total_length(Points points, const std::vector<Edge>& edges) {
  LengthSum sum;
  for (const Edge& edge : edges) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure().middle();
}

// The least weight of all triangulations that flips reach from the Delaunay triangulation: of all there are.
double min_weight_by_flips(Points points) {
  const Triangulation start = delaunay_triangulation(points);
  std::map<std::vector<Edge>, FlipTriangulation> seen;
  std::vector<std::vector<Edge>> open = {edges_of(start)};
  seen.emplace(open.front(), FlipTriangulation(start));
  double least = total_length(points, open.front());
  while (!open.empty()) {
    const FlipTriangulation current = seen.at(open.back());
    open.pop_back();
    for (Index e = 0; e < current.edge_count(); ++e) {
      if (!is_flippable(points, current, e)) continue;
      FlipTriangulation flipped = current;
      flipped.flip(e);
      std::vector<Edge> edges = edges_of(flipped.triangulation());
      least = std::min(least, total_length(points, edges));
      if (seen.emplace(edges, flipped).second) open.push_back(std::move(edges));
    }
  }
  return least;
}

TEST(LeafTriangulation, IsOptimalAmongAllTriangulations) {
  for (const std::size_t n : {3, 4, 5, 6, 7}) {
    for (const test::Instance& instance : test::instances(n)) {
      if (instance.name == "huge" || instance.name == "tiny") continue;  // for the tolerance's sake
      SCOPED_TRACE(instance.name + " " + std::to_string(n));
      const double least = min_weight_by_flips(instance.points);
      const double found =
          total_length(instance.points, minimum_weight_edges(instance.points, all_of(instance.points)));
      EXPECT_NEAR(found, least, 1e-13 * least);
    }
  }
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::vector<Point> points = seed % 2 == 0 ? test::uniform_points(8, seed) : test::lattice_points(8, seed);
    if (all_collinear(points)) continue;
    const double least = min_weight_by_flips(points);
    EXPECT_NEAR(total_length(points, minimum_weight_edges(points, all_of(points))), least, 1e-13 * least);
  }
}

TEST(LeafTriangulation, FindsTheReportsOptimum) {
  const std::vector<Point> points = test::report_example();
  const std::vector<Edge> edges = minimum_weight_edges(points, all_of(points));
  EXPECT_EQ(edges.size(), 3 * 10 - 3 - 6U);
  EXPECT_NEAR(total_length(points, edges), 70.9585925243, 5e-11);
}

TEST(LeafTriangulation, SinglePointsPairsAndLines) {
  const std::vector<Point> points = {{2, 2}, {0, 0}, {3, 3}, {1, 1}, {5, 0}};
  EXPECT_TRUE(minimum_weight_edges(points, std::vector<Index>{2}).empty());
  EXPECT_EQ(minimum_weight_edges(points, std::vector<Index>{4, 1}), (std::vector<Edge>{{1, 4}}));
  EXPECT_EQ(minimum_weight_edges(points, std::vector<Index>{0, 1, 2, 3}), (std::vector<Edge>{{0, 2}, {0, 3}, {1, 3}}));
}

TEST(QuadtreeTriangulation, IsValidOnAllShapes) {
  for (const char* capacity : {"1", "4", "10"}) {
    test::expect_valid_on_all_shapes(quadtree_entry(), 1000, {{"capacity", capacity}});
  }
}

TEST(QuadtreeTriangulation, IsOptimalWhereOneLeafHoldsAll) {
  const std::vector<Point> points = test::report_example();
  const Solution solution = test::solve_checked(quadtree_entry(), points, {{"capacity", "10"}});
  EXPECT_NEAR(weight(points, solution.triangulation).middle(), 70.9585925243, 5e-11);
  EXPECT_EQ(solution.counters.at("leaves"), 1);
}

TEST(QuadtreeTriangulation, ContainsEveryLeafsEdges) {
  const std::vector<Point> points = test::uniform_points(200, 6);
  const std::vector<Edge> edges = edges_of(test::solve_checked(quadtree_entry(), points).triangulation);
  std::size_t leaves = 0;
  const Quadtree tree(points, 4);
  for (const Quadtree::Cell& cell : tree.cells()) {
    if (!cell.is_leaf) continue;
    ++leaves;
    for (const Edge& edge : minimum_weight_edges(points, tree.points_of(cell))) {
      EXPECT_TRUE(std::binary_search(edges.begin(), edges.end(), edge));
    }
  }
  EXPECT_GT(leaves, 50U);
}

TEST(QuadtreeTriangulation, ClustersFinerThanTheGridKeepTheirDelaunayEdges) {
  // The cluster's side is 2^-52 of the square's, beyond the greatest depth; so is the run of collinear points.
  std::vector<Point> points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (const Point& p : test::lattice_points(12, 4)) points.push_back({0x1p-60 * p.x + 0x1p-55, 0x1p-60 * p.y});
  for (int i = 0; i < 6; ++i) points.push_back({-0.75 + 0x1p-53 * i, -0.625});
  const Solution solution = test::solve_checked(quadtree_entry(), points);
  EXPECT_GE(solution.counters.at("overfull_leaves"), 1);
}

TEST(QuadtreeTriangulation, RefusesOtherCapacities) {
  const std::vector<Point> points = test::report_example();
  for (const char* capacity : {"0", "11", "-3"}) {
    Context context = test::context_for(quadtree_entry(), {{"capacity", capacity}});
    EXPECT_THROW(quadtree_entry().function(points, context), InputError);
  }
}

}  // namespace
}  // namespace mwt
