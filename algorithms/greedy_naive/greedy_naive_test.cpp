#include "algorithms/greedy_naive/greedy_naive.h"

#include "algorithms/common/testing/instances.h"
#include "algorithms/flip_naive/flip_naive.h"
#include "geometry/mesh/edge_order.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {
namespace {

// The source report's greedy taken literally: every pair against every other edge and every point.
std::vector<Edge> literal_greedy_edges(Points points) {
  std::vector<Edge> pairs;
  for (Index a = 0; a < points.size(); ++a) {
    for (Index b = a + 1; b < points.size(); ++b) pairs.push_back({a, b});
  }
  std::stable_sort(pairs.begin(), pairs.end(), [&](const Edge& e, const Edge& f) {
    return compare_length(points[e.a], points[e.b], points[f.a], points[f.b]) < 0;
  });
  std::vector<Edge> kept;
  for (const Edge& e : pairs) {
    const Point &a = points[e.a], &b = points[e.b];
    const bool through_a_point =
        std::any_of(points.begin(), points.end(), [&](const Point& p) { return in_segment_interior(p, a, b); });
    const bool crosses = std::any_of(kept.begin(), kept.end(),
                                     [&](const Edge& f) { return segments_cross(a, b, points[f.a], points[f.b]); });
    if (!through_a_point && !crosses) kept.push_back(e);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

// Claim C1: section 5.1.3 of the source report.
TEST(GreedyNaive, ReproducesTheReportsExample) {
  const std::vector<Point> points = test::report_example();
  const Solution solution = test::solve_checked(greedy_naive_entry(), points);
  // As printed there, in its order; corners turned to counter-clockwise order.
  const std::vector<Triangle> expected = {{6, 7, 8}, {0, 3, 1}, {5, 9, 7}, {1, 3, 6}, {3, 7, 6}, {7, 9, 8},
                                          {3, 5, 7}, {1, 6, 8}, {0, 2, 3}, {2, 4, 3}, {3, 4, 5}, {4, 9, 5}};
  EXPECT_EQ(solution.triangulation.triangles, expected);
  EXPECT_NEAR(weight(points, solution.triangulation).middle(), 70.9585925243, 5e-11);
  EXPECT_NEAR(perimeter_sum(points, solution.triangulation).middle(), 116.9624275385, 5e-11);
}

TEST(GreedyNaive, IsValidOnAllShapes) { test::expect_valid_on_all_shapes(greedy_naive_entry(), 100); }

TEST(GreedyNaiveSlow, IsValidOnAllShapesOf1000Points) {
  for (const test::Instance& instance : test::instances(1000)) {
    if (instance.name == "huge" || instance.name == "tiny") continue;  // minutes of exact arithmetic
    SCOPED_TRACE(instance.name);
    test::solve_checked(greedy_naive_entry(), instance.points);
  }
}

TEST(GreedyNaive, EqualsTheLiteralAlgorithm) {
  for (const std::size_t n : {3, 4, 5, 6, 8, 12, 20}) {
    for (const test::Instance& instance : test::instances(n)) {
      SCOPED_TRACE(instance.name + " " + std::to_string(n));
      EXPECT_EQ(edges_of(greedy_naive(instance.points)), literal_greedy_edges(instance.points));
    }
  }
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const std::vector<Point> points = test::lattice_points(15, seed);
    if (all_collinear(points)) continue;
    EXPECT_EQ(edges_of(greedy_naive(points)), literal_greedy_edges(points)) << "seed " << seed;
  }
}

TEST(GreedyNaive, TiesGoToTheSmallerIndices) {
  // The diagonals 0-2 and 1-3 of a square are equal: 0-2 comes first.
  const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Triangle> expected = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(greedy_naive(square).triangles, expected);
}

TEST(GreedyNaive, IsOptimalUnderFlips) {
  for (const test::Instance& instance : test::instances(60)) {
    SCOPED_TRACE(instance.name);
    const FlipSearch search =
        flip_search(instance.points, greedy_naive(instance.points), FlipImprovement::first, std::nullopt);
    EXPECT_TRUE(search.flips.empty());
  }
}

TEST(GreedyNaive, RefusesTooManyPoints) {
  const std::vector<Point> points = test::uniform_points(10'001, 1);
  EXPECT_THROW(greedy_naive(points), NotApplicable);
}

TEST(EdgeOrder, IsExactOnNearTiesAndExtremes) {
  for (const std::size_t n : {10, 30}) {
    for (const test::Instance& instance : test::instances(n)) {
      SCOPED_TRACE(instance.name + " " + std::to_string(n));
      const Points points = instance.points;
      std::vector<Edge> pairs;
      for (Index b = 1; b < n; ++b) {
        for (Index a = 0; a < b; ++a) pairs.push_back({a, b});
      }
      sort_by_length(points, pairs);
      for (std::size_t i = 1; i < pairs.size(); ++i) {
        const Edge &e = pairs[i - 1], &f = pairs[i];
        const int comparison = compare_length(points[e.a], points[e.b], points[f.a], points[f.b]);
        EXPECT_TRUE(comparison < 0 || (comparison == 0 && e < f));
      }
    }
  }
}

}  // namespace
}  // namespace mwt
