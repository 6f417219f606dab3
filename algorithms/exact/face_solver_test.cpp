#include "algorithms/exact/face_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "algorithms/exact/naive_candidates.h"
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

}  // namespace
}  // namespace mwt
