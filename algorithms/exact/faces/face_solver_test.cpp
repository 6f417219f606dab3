#include "algorithms/exact/faces/face_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "algorithms/exact/exact.h"
#include "algorithms/exact/search_stopped.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "geometry/checker.h"
#include "geometry/weight.h"

namespace mwt {
namespace {

using Random = std::mt19937_64;

std::vector<Point> distinct(std::vector<Point> points) {
  std::vector<Point> result;
  for (const Point& p : points) {
    if (std::find(result.begin(), result.end(), p) == result.end()) result.push_back(p);
  }
  return result;
}

double uniform(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

double integer_below(Random& random, std::uint64_t bound) { return static_cast<double>(random() % bound); }

std::vector<Point> uniform_points(std::size_t n, Random& random) {
  std::vector<Point> points(n);
  for (Point& p : points) p = {uniform(random), uniform(random)};
  return points;
}

std::vector<Point> grid_points(std::size_t n, std::uint64_t side, Random& random) {
  std::vector<Point> points(n);
  for (Point& p : points) p = {integer_below(random, side), integer_below(random, side)};
  return distinct(points);
}

std::vector<Point> clustered_points(std::size_t n, Random& random) {
  std::vector<Point> points(n);
  for (Point& p : points) {
    const double spread = (random() & 1) != 0 ? 1e-3 : 1;
    p = {0.5 + spread * uniform(random), 0.5 + spread * uniform(random)};
  }
  return points;
}

// Points of x^2 + y^2 = 65^2, 36 in all.
std::vector<Point> cocircular_points(std::size_t n, Random& random) {
  std::vector<Point> circle;
  for (int x = -65; x <= 65; ++x) {
    for (int y = -65; y <= 65; ++y) {
      if (x * x + y * y == 65 * 65) circle.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  std::shuffle(circle.begin(), circle.end(), random);
  circle.resize(n);
  return circle;
}

std::vector<Point> row_points(std::size_t n, Random& random) {
  std::vector<Point> points(n);
  for (Point& p : points) p = {integer_below(random, n), 5 * integer_below(random, 3)};
  return distinct(points);
}

// A regular polygon with its centre, moved by up to `jitter`.
std::vector<Point> wheel(std::size_t spokes, double jitter, Random& random) {
  std::vector<Point> points{{0, 0}};
  for (std::size_t i = 0; i < spokes; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(spokes);
    points.push_back({std::cos(angle) + jitter * uniform(random), std::sin(angle) + jitter * uniform(random)});
  }
  return points;
}

struct Family {
  const char* name;
  std::function<std::vector<Point>(std::size_t, Random&)> make;
};

const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      {"uniform", uniform_points},
      {"clustered", clustered_points},
      {"small grid", [](std::size_t n, Random& random) { return grid_points(n, 4, random); }},
      {"grid", [](std::size_t n, Random& random) { return grid_points(n, 8, random); }},
      {"integers", [](std::size_t n, Random& random) { return grid_points(n, 1000, random); }},
      {"cocircular", cocircular_points},
      {"rows", row_points},
      {"wheel", [](std::size_t n, Random& random) { return wheel(n - 1, 0, random); }},
      {"jittered wheel", [](std::size_t n, Random& random) { return wheel(n - 1, 1e-3, random); }},
      {"tiny",
       [](std::size_t n, Random& random) {
         std::vector<Point> points = uniform_points(n, random);
         for (Point& p : points) p = {p.x * 1e-300, p.y * 1e-300};
         return points;
       }},
      {"huge",
       [](std::size_t n, Random& random) {
         std::vector<Point> points = uniform_points(n, random);
         for (Point& p : points) p = {p.x * 1e300, p.y * 1e300};
         return points;
       }},
  };
  return all;
}

bool spans_a_triangle(const std::vector<Point>& points) { return points.size() >= 3 && !all_collinear(points); }

FaceSolution solve(const CandidateGraph& graph, int threads = 1) {
  Context context;
  context.threads = threads;
  return solve_faces(graph, context);
}

void expect_valid(Points points, const FaceSolution& solution) {
  const Triangulation triangulation{static_cast<Index>(points.size()), solution.triangles};
  const auto violation = find_violation(points, triangulation);
  ASSERT_FALSE(violation) << violation->message;
  const Interval found = weight(points, triangulation);
  EXPECT_LE(solution.optimum.lower, found.upper);
  EXPECT_LE(found.lower, solution.optimum.upper);
}

void expect_optimal(Points points, const FaceSolution& solution, const Interval& optimum) {
  expect_valid(points, solution);
  EXPECT_TRUE(solution.proved);
  EXPECT_EQ(solution.undecided_ties, 0);
  EXPECT_TRUE(overlap(solution.optimum, optimum)) << solution.optimum.middle() << " but " << optimum.middle();
  const Interval found = weight(points, {static_cast<Index>(points.size()), solution.triangles});
  EXPECT_LE(found.upper - optimum.lower, 1e-12 * optimum.upper);
}

// How the graphs of the tests come about, from the largest faces to the smallest.
CandidateGraph hull_only(Points points) {
  return naive::make_graph(points, naive::possible_edges(points), naive::hull_edges(points));
}
CandidateGraph uncrossed(Points points) {
  const auto edges = naive::possible_edges(points);
  return naive::make_graph(points, edges, naive::uncrossed_edges(points, edges));
}
CandidateGraph locally_minimal(Points points) {
  const auto edges = naive::LocallyMinimalEdges(points).edges();
  return naive::make_graph(points, edges, naive::uncrossed_edges(points, edges));
}

void compare_with_sweep(std::size_t instances, std::size_t largest, std::uint64_t seed) {
  Random random(seed);
  for (const Family& family : families()) {
    for (std::size_t i = 0; i < instances; ++i) {
      const std::size_t n = 4 + i % (largest - 3);
      const std::vector<Point> points = family.make(n, random);
      if (!spans_a_triangle(points)) continue;
      SCOPED_TRACE(testing::Message() << family.name << " instance " << i << " of " << points.size() << " points");
      const Interval optimum = naive::SweptOptimum(points).weight();
      expect_optimal(points, solve(hull_only(points)), optimum);
      expect_optimal(points, solve(uncrossed(points)), optimum);
      expect_optimal(points, solve(locally_minimal(points)), optimum);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(FaceSolver, AgreesWithSweepOnSmallInstances) { compare_with_sweep(14, 10, 1); }

TEST(FaceSolverSlow, AgreesWithSweepOnManyInstances) { compare_with_sweep(200, 13, 2); }

const std::vector<Point> kSquareWithPoints{{0, 0}, {20, 0}, {20, 20}, {0, 20}, {8, 7}, {12, 13}, {13, 6}};

TEST(FaceSolver, TriangulatesAroundSlitsAsPolygon) {
  const CandidateGraph graph = naive::graph_with_certain(kSquareWithPoints, {{0, 4}, {4, 6}, {4, 5}});
  const FaceSolution solution = solve(graph);
  expect_valid(kSquareWithPoints, solution);
  EXPECT_TRUE(solution.proved);
  EXPECT_EQ(solution.faces, 1);
  EXPECT_EQ(solution.max_face, 10) << "the square and both sides of three edges";
  EXPECT_EQ(solution.faces_with_holes, 0);
}

TEST(FaceSolver, TriangulatesHolesOfAllKinds) {
  const std::vector<std::set<Edge>> inner_edges = {
      {}, {{4, 5}}, {{0, 4}}, {{4, 5}, {5, 6}}, {{0, 4}, {5, 6}}, {{4, 5}, {4, 6}, {5, 6}}};
  const Interval optimum = naive::SweptOptimum(kSquareWithPoints).weight();
  for (const auto& certain : inner_edges) {
    const CandidateGraph graph = naive::graph_with_certain(kSquareWithPoints, certain);
    const FaceSolution solution = solve(graph);
    expect_valid(kSquareWithPoints, solution);
    EXPECT_TRUE(solution.proved);
    EXPECT_EQ(solution.faces, 1);
    EXPECT_EQ(solution.faces_with_holes, 1);
    EXPECT_GE(solution.optimum.upper, optimum.lower);
    for (const Edge& edge : certain) {
      const auto edges = edges_of({static_cast<Index>(kSquareWithPoints.size()), solution.triangles});
      EXPECT_TRUE(std::binary_search(edges.begin(), edges.end(), edge));
    }
  }
}

TEST(FaceSolver, SolvesWheels) {
  Random random(3);
  for (std::size_t spokes = 13; spokes <= 20; ++spokes) {
    SCOPED_TRACE(spokes);
    const std::vector<Point> points = wheel(spokes, spokes % 3 == 0 ? 1e-3 : 0, random);
    const FaceSolution solution = solve(hull_only(points));
    expect_valid(points, solution);
    EXPECT_TRUE(solution.proved);
    if (spokes <= 14) {
      EXPECT_TRUE(overlap(solution.optimum, naive::SweptOptimum(points).weight()));
    }
  }
}

// All diagonals of a convex polygon.
CandidateGraph complete_graph(const std::vector<Point>& convex) {
  std::vector<Edge> edges;
  for (Index a = 0; a < convex.size(); ++a) {
    for (Index b = a + 1; b < convex.size(); ++b) edges.push_back({a, b});
  }
  return naive::make_graph(convex, edges, naive::hull_edges(convex));
}

// The classical interval program, in double-doubles, over points in convex position in order.
Interval convex_optimum(const std::vector<Point>& points) {
  const std::size_t n = points.size();
  std::vector<std::vector<DoubleDouble>> best(n, std::vector<DoubleDouble>(n));
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) {
      DoubleDouble least = j == i + 1 ? 0.0 : std::numeric_limits<double>::infinity();
      for (std::size_t k = i + 1; k < j; ++k) {
        const DoubleDouble sum = best[i][k] + best[k][j];
        if (sum < least) least = sum;
      }
      best[i][j] = least + length(points[i], points[j]);
    }
  }
  return enclose(best[0][n - 1], 4 * static_cast<double>(n) * kDoubleDoubleError);
}

std::vector<Point> regular_polygon(std::size_t n) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

// Points of x^2 + y^2 = (5 * 13 * 17)^2, 108 in all, counter-clockwise.
std::vector<Point> integer_circle() {
  std::vector<Point> points;
  constexpr int kRadius = 5 * 13 * 17;
  for (int x = -kRadius; x <= kRadius; ++x) {
    const int y = static_cast<int>(std::lround(std::sqrt(static_cast<double>(kRadius * kRadius - x * x))));
    if (x * x + y * y != kRadius * kRadius) continue;
    points.push_back({static_cast<double>(x), static_cast<double>(y)});
    if (y != 0) points.push_back({static_cast<double>(x), -static_cast<double>(y)});
  }
  std::sort(points.begin(), points.end(),
            [](const Point& p, const Point& q) { return std::atan2(p.y, p.x) < std::atan2(q.y, q.x); });
  return points;
}

TEST(FaceSolver, SolvesLargeConvexFaces) {
  for (const auto& points : {regular_polygon(70), regular_polygon(101), integer_circle()}) {
    const FaceSolution solution = solve(complete_graph(points));
    expect_optimal(points, solution, convex_optimum(points));
    EXPECT_EQ(solution.max_face, points.size());
    EXPECT_EQ(solution.faces_with_holes, 0);
    EXPECT_GT(solution.precise_comparisons, 0);
  }
}

TEST(FaceSolverSlow, SolvesAThousandCocircularPoints) {
  const std::vector<Point> points = regular_polygon(1000);
  expect_optimal(points, solve(complete_graph(points)), convex_optimum(points));
}

// An apex over a row: a star of many edges, all certain.
TEST(FaceSolver, WalksAroundLargeStars) {
  std::vector<Point> points{{0, 7}};
  std::vector<Edge> edges;
  constexpr Index kRow = 3000;
  for (Index i = 1; i <= kRow; ++i) {
    points.push_back({static_cast<double>(i), 0});
    edges.push_back({0, i});
    if (i > 1) edges.push_back({i - 1, i});
  }
  const FaceSolution solution = solve(naive::make_graph(points, edges, {edges.begin(), edges.end()}));
  expect_valid(points, solution);
  EXPECT_TRUE(solution.proved);
  EXPECT_EQ(solution.faces, 0);
}

// A minimum weight triangulation of which a third of the edges may be replaced by the other diagonals of their
// quadrilaterals: many faces of all kinds, also with holes and isolated vertices.
CandidateGraph loosened_optimum(Points points, Random& random) {
  Context context;
  const Triangulation optimum = exact(points, context).triangulation;
  const auto adjacent = adjacency_of(optimum);
  std::vector<Edge> edges = edges_of(optimum);
  std::set<Edge> certain(edges.begin(), edges.end());
  for (Index t = 0; t < optimum.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index u = adjacent[t][i];
      if (u == kNoIndex || u < t || random() % 3 != 0) continue;
      const Edge side = directed_edge(optimum.triangles[t], static_cast<int>(i));
      certain.erase(make_edge(side.a, side.b));
      const Index apex = optimum.triangles[t][i];
      const auto place = std::find(adjacent[u].begin(), adjacent[u].end(), t) - adjacent[u].begin();
      const Index other = optimum.triangles[u][static_cast<std::size_t>(place)];
      if (is_strictly_convex(points[apex], points[side.a], points[other], points[side.b])) {
        edges.push_back(make_edge(apex, other));
      }
    }
  }
  return naive::make_graph(points, edges, certain);
}

TEST(FaceSolver, DoesNotDependOnThreads) {
  Random random(11);
  for (const auto& points : {uniform_points(9000, random), grid_points(12000, 120, random)}) {
    const CandidateGraph graph = loosened_optimum(points, random);
    const FaceSolution one = solve(graph, 1);
    expect_valid(points, one);
    EXPECT_TRUE(one.proved);
    EXPECT_GT(one.faces_with_holes, 0);
    for (const int threads : {2, 5}) {
      const FaceSolution other = solve(graph, threads);
      EXPECT_EQ(one.triangles, other.triangles);
      EXPECT_EQ(one.optimum, other.optimum);
      EXPECT_EQ(one.dp_cells, other.dp_cells);
    }
  }
}

FaceSolution solve_too_late(const CandidateGraph& graph) {
  Context context;
  context.deadline = Context::Clock::now() - std::chrono::seconds(1);
  return solve_faces(graph, context);
}

TEST(FaceSolver, ReturnsATriangulationAndBoundsAtTheDeadline) {
  const std::vector<Point> circle = integer_circle();
  const Interval optimum = convex_optimum(circle);
  const FaceSolution solution = solve_too_late(complete_graph(circle));
  expect_valid(circle, solution);
  EXPECT_FALSE(solution.proved);
  EXPECT_EQ(solution.unsolved_faces, 1);
  EXPECT_LE(solution.optimum.lower, optimum.upper);
  EXPECT_GE(solution.optimum.upper, optimum.lower);
  EXPECT_GT(solution.optimum.lower, 0);
}

TEST(FaceSolver, StopsWithABoundWhereTheDeadlineComesBeforeTheFacesAreKnown) {
  Random random(4);
  for (const auto& points : {uniform_points(13, random), row_points(14, random)}) {
    try {
      (void)solve_too_late(hull_only(points));
      ADD_FAILURE() << "must stop";
    } catch (const SearchStopped& stopped) {
      EXPECT_GT(stopped.lower_bound, 0);
      EXPECT_LE(stopped.lower_bound, naive::SweptOptimum(points).weight().upper);
    }
  }
}

TEST(FaceSolver, ReportsProgress) {
  Random random(8);
  const std::vector<Point> points = uniform_points(30, random);
  Context context;
  double last = 0;
  context.progress = [&](const std::string&, double done) { last = done; };
  const FaceSolution solution = solve_faces(locally_minimal(points), context);
  EXPECT_TRUE(solution.proved);
  EXPECT_EQ(last, 1);
}

TEST(FaceSolver, SaysWhenCandidatesContainNoTriangulation) {
  const std::vector<Point> points{{0, 0}, {4, 0}, {6, 3}, {3, 6}, {-1, 3}};
  auto edges = naive::possible_edges(points);
  std::erase_if(edges, [&](const Edge& e) { return !naive::hull_edges(points).contains(e) && e != Edge{0, 2}; });
  Context context;
  EXPECT_THROW((void)solve_faces(naive::make_graph(points, edges, naive::hull_edges(points)), context),
               std::logic_error);
}

}  // namespace
}  // namespace mwt
