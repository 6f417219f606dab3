#include "algorithms/polygon_dp/polygon_dp.h"

#include <limits>
#include <numeric>

#include "algorithms/common/testing/instances.h"
#include "base/error.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {
namespace {

std::vector<Index> whole_cycle(Points points) {
  std::vector<Index> cycle(points.size());
  std::iota(cycle.begin(), cycle.end(), Index{0});
  return cycle;
}

// Whether the diagonal between two vertices of the polygon lies inside it and passes through no vertex, by definition.
bool is_inner_diagonal(Points polygon, std::size_t i, std::size_t j) {
  const std::size_t n = polygon.size();
  const Point &a = polygon[i], &b = polygon[j];
  for (std::size_t k = 0; k < n; ++k) {
    if (segments_cross(a, b, polygon[k], polygon[(k + 1) % n])) return false;
  }
  const Point &before = polygon[(i + n - 1) % n], &after = polygon[(i + 1) % n];
  const bool left_of_after = orientation(a, after, b) > 0, right_of_before = orientation(a, before, b) < 0;
  const bool is_reflex = orientation(before, a, after) < 0;
  return is_reflex ? left_of_after || right_of_before : left_of_after && right_of_before;
}

// The least sum of diagonals over all triangulations of the chain i .. j, by recursion over all of them.
double brute_force(Points polygon, std::size_t i, std::size_t j) {
  if (j - i < 2) return 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = i + 1; k < j; ++k) {
    if (orientation(polygon[i], polygon[k], polygon[j]) <= 0) continue;
    const bool inside =
        (k == i + 1 || is_inner_diagonal(polygon, i, k)) && (j == k + 1 || is_inner_diagonal(polygon, k, j));
    if (!inside) continue;
    const double diagonals =
        (k > i + 1 ? length(polygon[i], polygon[k]).high : 0) + (j > k + 1 ? length(polygon[k], polygon[j]).high : 0);
    best = std::min(best, diagonals + brute_force(polygon, i, k) + brute_force(polygon, k, j));
  }
  return best;
}

// Vertices at random distances from the origin in angular order: a star-shaped polygon, mostly not convex.
std::vector<Point> star_shaped_polygon(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point> polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    const double distance = 0.2 + test::random_unit(random);
    polygon.push_back({distance * std::cos(angle), distance * std::sin(angle)});
  }
  return polygon;
}

void expect_optimal(Points polygon) {
  const std::vector<Index> cycle = whole_cycle(polygon);
  const Interval boundary = cycle_length(polygon, cycle);
  const double diagonals = brute_force(polygon, 0, polygon.size() - 1);
  const PolygonTriangulation by_edges = triangulate_polygon(polygon, cycle, PolygonObjective::edges);
  const PolygonTriangulation by_perimeter = triangulate_polygon(polygon, cycle, PolygonObjective::perimeter);
  const double tolerance = 1e-12 * (boundary.upper + diagonals);
  EXPECT_NEAR(by_edges.cost.middle(), boundary.middle() + diagonals, tolerance);
  EXPECT_NEAR(by_perimeter.cost.middle(), boundary.middle() + 2 * diagonals, tolerance);
  const Triangulation triangulation{static_cast<Index>(polygon.size()), by_edges.triangles};
  EXPECT_EQ(by_edges.triangles.size(), polygon.size() - 2);
  EXPECT_TRUE(overlap(by_edges.cost, weight(polygon, triangulation)));
  const Triangulation report_like{static_cast<Index>(polygon.size()), by_perimeter.triangles};
  EXPECT_TRUE(overlap(by_perimeter.cost, perimeter_sum(polygon, report_like)));
}

TEST(PolygonDp, EqualsBruteForceOnConvexPolygons) {
  for (std::size_t n = 3; n <= 10; ++n) {
    std::vector<Point> parabola = test::parabola_points(n);
    expect_optimal(parabola);
    expect_optimal(test::scaled(test::circle_points(n), 1, 0.3));
  }
}

TEST(PolygonDp, EqualsBruteForceOnStarShapedPolygons) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    expect_optimal(star_shaped_polygon(5 + seed % 6, seed));
  }
}

TEST(PolygonDp, TakesCollinearVerticesAndReflexOnes) {
  // An L with vertices in the middle of its sides; the diagonal from (0, 2) to (2, 0) would touch the reflex corner (1,
  // 1).
  const std::vector<Point> ell = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}};
  expect_optimal(ell);
  const PolygonTriangulation result = triangulate_polygon(ell, whole_cycle(ell), PolygonObjective::edges);
  // Three unit squares, each with a diagonal.
  EXPECT_NEAR(result.cost.middle(), 8 + 2 + 3 * std::sqrt(2.0), 1e-13);
}

TEST(PolygonDp, SpiralsAreTriangulatedInside) {
  const std::vector<Point> spiral = {{0, 0}, {10, 0}, {10, 10}, {2, 10}, {2, 4}, {6, 4},
                                     {6, 6}, {4, 6},  {4, 8},   {8, 8},  {8, 2}, {0, 2}};
  expect_optimal(spiral);
}

TEST(PolygonDp, ListsTrianglesInPreorder) {
  // A long hexagon that its short diagonals cut into a chain of triangles; of 1-4 and 2-5, equally long, the split with
  // the smaller k wins.
  const std::vector<Point> points = {{0, 0}, {3, -1}, {6, -1}, {9, 0}, {6, 1}, {3, 1}};
  const std::vector<Triangle> triangles =
      triangulate_polygon(points, whole_cycle(points), PolygonObjective::edges).triangles;
  const std::vector<Triangle> expected = {{0, 1, 5}, {1, 2, 5}, {2, 4, 5}, {2, 3, 4}};
  EXPECT_EQ(triangles, expected);
}

TEST(PolygonDp, RefusesWhatIsNoCounterClockwisePolygon) {
  const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Index> clockwise = {3, 2, 1, 0}, two = {0, 1};
  const std::vector<Point> flat = {{0, 0}, {1, 0}, {2, 0}};
  EXPECT_THROW(triangulate_polygon(square, clockwise, PolygonObjective::edges), InputError);
  EXPECT_THROW(triangulate_polygon(square, two, PolygonObjective::edges), InputError);
  EXPECT_THROW(triangulate_polygon(flat, whole_cycle(flat), PolygonObjective::edges), InputError);
}

TEST(PolygonDp, EntryCertifiesTheOptimumOfPointsOnTheHull) {
  const std::vector<test::Instance> instances = {{"parabola", test::parabola_points(40)},
                                                 {"rows", test::row_points(41)},
                                                 {"fan", test::fan_points(30)},
                                                 {"huge rows", test::scaled(test::row_points(20), 1e298, 1e298)},
                                                 {"tiny rows", test::scaled(test::row_points(20), 1e-300, 1e-300)}};
  for (const test::Instance& instance : instances) {
    SCOPED_TRACE(instance.name);
    for (const char* objective : {"edges", "perimeter"}) {
      const Solution solution = test::solve_checked(polygon_dp_entry(), instance.points, {{"objective", objective}});
      const Interval found = weight(instance.points, solution.triangulation);
      ASSERT_EQ(solution.optimum.has_value(), std::string(objective) == "edges");
      if (!solution.optimum) continue;
      EXPECT_EQ(solution.optimum->upper, found.upper);
      EXPECT_LE(solution.optimum->lower, found.upper);
      EXPECT_LT(solution.optimum->relative_width(), 1e-15);
    }
  }
}

// Closed form: rails, rungs and diagonals of two collinear rows of k points at distance 3.
TEST(PolygonDp, TwoRowsHaveTheirClosedForm) {
  constexpr double k = 25;
  const std::vector<Point> points = test::row_points(50);
  const Solution solution = test::solve_checked(polygon_dp_entry(), points);
  ASSERT_TRUE(solution.optimum.has_value());
  EXPECT_NEAR(solution.optimum->middle(), 2 * (k - 1) + 3 * k + (k - 1) * std::sqrt(10.0), 1e-11);
}

TEST(PolygonDp, IsValidOnLargerSets) {
  test::solve_checked(polygon_dp_entry(), test::parabola_points(300));
  test::solve_checked(polygon_dp_entry(), test::row_points(300));
}

TEST(PolygonDpSlow, IsValidOn1000Points) {
  test::solve_checked(polygon_dp_entry(), test::parabola_points(1000));
  test::solve_checked(polygon_dp_entry(), test::fan_points(1000));
}

TEST(PolygonDp, EntryNamesTheFirstInteriorPoint) {
  Context context = test::context_for(polygon_dp_entry());
  const std::vector<Point> points = test::report_example();
  try {
    polygon_dp_entry().function(points, context);
    FAIL() << "points inside the hull were accepted";
  } catch (const NotApplicable& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("point 3 lies inside"), std::string::npos) << refusal.what();
  }
}

// Claim C7: the best diagonals of a convex 12-gon, whose optimum an interior point would make lighter.
TEST(PolygonDp, HullBoundCounterexample) {
  const std::vector<Point> gon = {{4, 8},     {-2, 11},  {-13, 16}, {-30, 20}, {-63, 16}, {-96, -35},
                                  {-45, -96}, {17, -64}, {19, -30}, {15, -13}, {11, -2},  {8, 4}};
  const Solution solution = test::solve_checked(polygon_dp_entry(), gon);
  const std::vector<Index> hull = convex_hull(gon);
  ASSERT_TRUE(solution.optimum.has_value());
  EXPECT_NEAR(solution.optimum->middle() - cycle_length(gon, hull).middle(), 493.7304, 5e-5);
  EXPECT_NEAR(solution.optimum->middle(), 848.848, 5e-4);
}

}  // namespace
}  // namespace mwt
