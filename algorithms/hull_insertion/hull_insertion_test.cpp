#include "algorithms/hull_insertion/hull_insertion.h"

#include <iomanip>
#include <sstream>

#include "algorithms/common/testing/instances.h"
#include "algorithms/hull_insertion/split_distribution.h"
#include "algorithms/hull_insertion/split_history.h"
#include "algorithms/polygon_dp/convex_polygon.h"
#include "generators/hull_bound_counterexample/hull_bound_counterexample.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {
namespace {

// The source report's insertion taken literally: scan the list for the triangles that hold p, replace each where it
// stands.
void insert_literally(Points points, std::vector<Triangle>& triangles, Index p) {
  std::vector<Triangle> result;
  for (const Triangle& triangle : triangles) {
    const auto [a, b, c] = triangle;
    if (!in_closed_triangle(points[p], points[a], points[b], points[c])) {
      result.push_back(triangle);
      continue;
    }
    for (const Triangle& part : {Triangle{a, b, p}, Triangle{b, c, p}, Triangle{c, a, p}}) {
      if (orientation(points[part[0]], points[part[1]], points[p]) != 0) result.push_back(part);
    }
  }
  triangles = std::move(result);
}

std::vector<Index> interior_points(Points points, const std::vector<Index>& hull) {
  std::vector<Index> interior;
  for (Index p = 0; p < points.size(); ++p) {
    if (std::find(hull.begin(), hull.end(), p) == hull.end()) interior.push_back(p);
  }
  return interior;
}

// Claim C2: section 5.2.3 of the source report.
TEST(HullInsertion, ReproducesTheReportsExample) {
  const std::vector<Point> points = test::report_example();
  const Solution solution = test::solve_checked(hull_insertion_entry(), points);
  const std::vector<Triangle> expected = {{4, 0, 2}, {4, 9, 5}, {9, 3, 5}, {3, 4, 5}, {9, 0, 3}, {0, 4, 3},
                                          {9, 8, 6}, {8, 0, 6}, {0, 9, 7}, {9, 6, 7}, {6, 0, 7}, {8, 1, 0}};
  EXPECT_EQ(solution.triangulation.triangles, expected);
  EXPECT_NEAR(weight(points, solution.triangulation).middle(), 86.5447479007, 5e-11);
  EXPECT_NEAR(perimeter_sum(points, solution.triangulation).middle(), 148.1347382914, 5e-11);
  EXPECT_EQ(solution.counters.at("hull_size"), 6);
  EXPECT_EQ(solution.counters.at("interior_points"), 4);
}

// Claim C7: the hull's own optimum may weigh more than the optimum of all points.
TEST(HullInsertion, TellsTheWeightOfTheHullsTriangulation) {
  const std::vector<Point> points = hull_bound_counterexample_points();
  const Solution solution = test::solve_checked(hull_insertion_entry(), points);
  EXPECT_NEAR(solution.counters.at("hull_weight"), 848.848, 5e-4);
}

// The counter was in the unit of the scaled points.
TEST(HullInsertion, TellsTheWeightOfTheHullsTriangulationAtAllScales) {
  for (const double scale : {0x1p-900, 0x1p900}) {
    const std::vector<Point> points = test::scaled(hull_bound_counterexample_points(), scale, scale);
    const Solution solution = test::solve_checked(hull_insertion_entry(), points);
    EXPECT_NEAR(solution.counters.at("hull_weight") / scale, 848.848, 5e-4);
  }
}

TEST(HullInsertion, OtherOrdersOfTheExampleGiveOtherWeights) {
  const std::vector<Point> points = test::report_example();
  const Solution by_x = test::solve_checked(hull_insertion_entry(), points, {{"order", "x"}});
  std::set<std::string> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Context context = test::context_for(hull_insertion_entry(), {{"order", "random"}});
    context.seed = seed;
    const Solution solution = hull_insertion_entry().function(points, context);
    std::ostringstream shown;
    shown << std::fixed << std::setprecision(2) << weight(points, solution.triangulation).middle();
    seen.insert(shown.str());
  }
  const std::set<std::string> known = {"84.42", "85.12", "86.54", "87.24"};
  EXPECT_EQ(seen, known);
  EXPECT_NE(by_x.triangulation.triangles.size(), 0U);
}

TEST(HullInsertion, IsValidOnAllShapesInAllOrders) {
  for (const char* order : {"index", "random", "x"}) {
    test::expect_valid_on_all_shapes(hull_insertion_entry(), 100, {{"order", order}});
  }
}

TEST(HullInsertion, IsValidOn1000PointsInAllOrders) {
  for (const char* order : {"index", "random", "x"}) {
    for (const std::vector<Point>& points :
         {test::uniform_points(1000, 1), test::grid_points(1000), test::lattice_points(1000, 2)}) {
      test::solve_checked(hull_insertion_entry(), points, {{"order", order}});
    }
  }
}

TEST(HullInsertion, EqualsTheLiteralAlgorithmTriangleByTriangle) {
  for (const std::size_t n : {4, 5, 10, 30, 100}) {
    for (const test::Instance& instance : test::instances(n)) {
      SCOPED_TRACE(instance.name + " " + std::to_string(n));
      const Points points = instance.points;
      const std::vector<Index> hull = convex_hull(points);
      std::vector<Triangle> literal = triangulate_polygon(points, hull, PolygonObjective::perimeter).triangles;
      for (const Index p : interior_points(points, hull)) insert_literally(points, literal, p);
      const Solution solution = test::solve_checked(hull_insertion_entry(), points);
      EXPECT_EQ(solution.triangulation.triangles, literal);
    }
  }
}

TEST(HullInsertion, APointOnAnEdgeSplitsBothSides) {
  // The first square is cut along 0-2; point 4 lies on that diagonal.
  const std::vector<Point> points = {{0, 0}, {4, 1}, {5, 5}, {1, 4}, {2, 2}};
  const std::vector<Index> square = {0, 1, 2, 3}, interior = {4};
  const std::vector<Triangle> cut = {{0, 2, 3}, {0, 1, 2}};
  const SplitTriangles result = insert_by_splitting(points, square, cut, interior);
  const std::vector<Triangle> expected = {{2, 3, 4}, {3, 0, 4}, {0, 1, 4}, {1, 2, 4}};
  EXPECT_EQ(result.triangles, expected);
  EXPECT_EQ(result.edge_splits, 2U);
}

// Insertion one by one through the search tree gives the same list as dealing out, from a polygon and from a triangle.
TEST(SplitHistory, AgreesWithDealingOut) {
  for (const std::size_t n : {5, 10, 100, 400}) {
    for (const test::Instance& instance : test::instances(n)) {
      SCOPED_TRACE(instance.name + " " + std::to_string(n));
      const Points points = instance.points;
      const std::vector<Index> hull = convex_hull(points);
      const std::vector<Index> interior = interior_points(points, hull);
      const std::vector<Triangle> start = triangulate_polygon(points, hull, PolygonObjective::edges).triangles;
      SplitHistory history(points, hull, start, interior.size());
      for (const Index p : interior) history.insert(p);
      const SplitTriangles dealt = insert_by_splitting(points, hull, start, interior);
      EXPECT_EQ(history.triangles(), dealt.triangles);
      EXPECT_EQ(history.edge_splits(), dealt.edge_splits);
      EXPECT_EQ(history.depth(), dealt.depth);
    }
  }
}

// Points on a parabola inside a triangle, left to right: each lies in a triangle of the one before.
std::vector<Point> nested_points(std::size_t n) {
  std::vector<Point> points = {{-1, -1}, {2, -1}, {0.5, 3}};
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(n);
    points.push_back({x, x * x});
  }
  return points;
}

TEST(SplitHistory, TakesOverWhereTrianglesNestDeeply) {
  const std::vector<Point> points = nested_points(20'000);
  const Solution solution = test::solve_checked(hull_insertion_entry(), points);
  EXPECT_GT(solution.counters.at("depth"), 5000);
}

TEST(SplitHistory, EqualsTheLiteralAlgorithmWhereItTakesOver) {
  const std::vector<Point> points = nested_points(300);
  std::vector<Triangle> literal = {{0, 1, 2}};
  for (Index p = 3; p < points.size(); ++p) insert_literally(points, literal, p);
  const Solution solution = test::solve_checked(hull_insertion_entry(), points);
  EXPECT_EQ(solution.triangulation.triangles, literal);
  EXPECT_GT(solution.counters.at("depth"), 100);
}

// Two mirrored chains and points on the edge between them: regions nest deeply on both sides, and each point on the
// axis has to split the innermost region of either.
TEST(SplitHistory, PointsOnSharedEdgesAgreeAcrossTheTakeover) {
  std::vector<Point> points = {{-1, 0}, {2, 0}, {0.5, 3}, {0.5, -3}};
  for (int i = 1; i < 512; ++i) {
    const double x = i / 512.0;
    points.push_back({x, 0.25 * x * x});
    points.push_back({x + 0x1p-11, 0});
    points.push_back({x, -0.25 * x * x});
  }
  std::vector<Triangle> literal = {{0, 1, 2}, {0, 3, 1}};
  for (Index p = 4; p < points.size(); ++p) insert_literally(points, literal, p);
  const Solution solution = test::solve_checked(hull_insertion_entry(), points);
  EXPECT_EQ(std::set<Triangle>(literal.begin(), literal.end()),
            std::set<Triangle>(solution.triangulation.triangles.begin(), solution.triangulation.triangles.end()));
  EXPECT_GT(solution.counters.at("points_on_edges"), 100);
  EXPECT_GT(solution.counters.at("depth"), 500);
}

TEST(HullInsertion, TheSeedDecidesTheRandomOrderOnly) {
  const std::vector<Point> points = test::uniform_points(50, 9);
  const auto triangles_with = [&](const char* order, std::uint64_t seed) {
    Context context = test::context_for(hull_insertion_entry(), {{"order", order}});
    context.seed = seed;
    return hull_insertion_entry().function(points, context).triangulation.triangles;
  };
  EXPECT_EQ(triangles_with("random", 5), triangles_with("random", 5));
  EXPECT_NE(triangles_with("random", 5), triangles_with("random", 6));
  EXPECT_EQ(triangles_with("index", 5), triangles_with("index", 6));
}

TEST(HullInsertion, TakesLargeHulls) {
  const std::vector<Point> points = test::parabola_points(kSmallPolygon + 100);
  Context context = test::context_for(hull_insertion_entry());
  const HullInsertion result = hull_insertion(points, InsertionOrder::index, 1, context);
  EXPECT_FALSE(find_violation(points, result.triangulation));
  EXPECT_FALSE(result.stop_reason);
  const PolygonTriangulation literal = triangulate_polygon(points, convex_hull(points), PolygonObjective::edges);
  EXPECT_LE(result.hull_weight.lower, literal.cost.upper * (1 + 1e-12));
}

TEST(HullInsertion, SaysThatTheHullIsNotOptimalForWantOfTime) {
  std::vector<Point> points = test::parabola_points(3000);
  points.push_back({0.5, 1});
  Context context = test::context_for(hull_insertion_entry());
  context.deadline = Context::Clock::now();
  const Solution solution = hull_insertion_entry().function(points, context);
  EXPECT_FALSE(find_violation(points, solution.triangulation));
  EXPECT_EQ(solution.stop_reason, StopReason::deadline);
}

}  // namespace
}  // namespace mwt
