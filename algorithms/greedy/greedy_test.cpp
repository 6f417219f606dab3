#include "algorithms/greedy/greedy.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/checker.h"
#include "geometry/predicates.h"
#include "geometry/testing/shapes.h"

namespace mwt {

namespace {

using test::make_shape;
using test::ShapeFamily;
using test::shapes;

// The definition, word for word: all pairs in order, each taken unless it crosses a taken one or passes through a
// point.
std::vector<Edge> naive_greedy(Points points) {
  std::vector<Edge> pairs;
  for (Index a = 0; a < points.size(); ++a) {
    for (Index b = a + 1; b < points.size(); ++b) pairs.push_back({a, b});
  }
  std::stable_sort(pairs.begin(), pairs.end(), [&](const Edge& one, const Edge& two) {
    return compare_length(points[one.a], points[one.b], points[two.a], points[two.b]) < 0;
  });
  std::vector<Edge> taken;
  for (const auto& [a, b] : pairs) {
    const auto crosses = [&, a = a, b = b](const Edge& e) {
      return segments_cross(points[a], points[b], points[e.a], points[e.b]);
    };
    const auto is_on_it = [&, a = a, b = b](const Point& p) { return in_segment_interior(p, points[a], points[b]); };
    if (std::none_of(taken.begin(), taken.end(), crosses) && std::none_of(points.begin(), points.end(), is_on_it)) {
      taken.push_back({a, b});
    }
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

void expect_equals_naive(const ShapeFamily& shape, std::size_t n, std::uint64_t seed) {
  // Where every decision needs multiple precision, the definition with its O(n^3) of them is for a dozen points.
  const std::vector<Point> points = make_shape(shape, std::min(n, shape.max_n / 5), seed);
  const Triangulation triangulation = greedy_triangulation(points);
  const auto violation = find_violation(points, triangulation);
  ASSERT_FALSE(violation) << shape.name << " n=" << n << " seed=" << seed << ": " << violation->message;
  ASSERT_EQ(edges_of(triangulation), naive_greedy(points)) << shape.name << " n=" << n << " seed=" << seed;
}

TEST(Greedy, EqualsNaiveOnSmallInstances) {
  for (const ShapeFamily& shape : shapes()) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) expect_equals_naive(shape, 3 + seed % 20, seed);
  }
}

TEST(Greedy, EqualsNaiveOnMiddlingInstances) {
  for (const ShapeFamily& shape : shapes()) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) expect_equals_naive(shape, 30 * seed, seed);
  }
}

TEST(GreedySlow, EqualsNaiveOnThousandsOfInstances) {
  for (const ShapeFamily& shape : shapes()) {
    for (std::uint64_t seed = 1; seed <= 240; ++seed) expect_equals_naive(shape, 3 + seed % 38, 1000 + seed);
  }
}

TEST(GreedySlow, EqualsNaiveOnLargeInstances) {
  for (const ShapeFamily& shape : shapes()) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) expect_equals_naive(shape, 40 + 10 * seed, seed);
    expect_equals_naive(shape, 500, 7);
  }
}

TEST(Greedy, IsValidOnAllShapes) {
  for (const ShapeFamily& shape : shapes()) {
    for (const std::size_t n : {3, 4, 5, 10, 100, 1000}) {
      const std::vector<Point> points = make_shape(shape, n, n);
      const auto violation = find_violation(points, greedy_triangulation(points));
      EXPECT_FALSE(violation) << shape.name << " n=" << n << ": " << violation->message;
    }
  }
}

// A hub of high degree whose spokes are fixed one after the other, and a wheel around another wheel.
TEST(Greedy, WheelsAreNoQuadraticCase) {
  for (const ShapeFamily& shape : shapes()) {
    if (shape.name.find("wheel") == std::string::npos) continue;
    const std::vector<Point> points = make_shape(shape, 30000, 1);
    EXPECT_FALSE(find_violation(points, greedy_triangulation(points))) << shape.name;
  }
}

TEST(Greedy, StopsAtTheDeadlineWithAValidTriangulation) {
  const std::vector<Point> points = make_shape(shapes().front(), 20000, 1);
  Context context;
  context.deadline = Context::Clock::now();
  const AlgorithmInfo info = greedy_entry();
  const Solution solution = info.function(points, context);
  EXPECT_EQ(solution.stop_reason, StopReason::deadline);
  EXPECT_FALSE(find_violation(points, solution.triangulation));
}

TEST(Greedy, EntryReportsWhatItDid) {
  const std::vector<Point> points = make_shape(shapes().front(), 2000, 1);
  Context context;
  const Solution solution = greedy_entry().function(points, context);
  EXPECT_FALSE(solution.stopped_early());
  EXPECT_EQ(edges_of(solution.triangulation), edges_of(greedy_triangulation(points)));
  EXPECT_GT(solution.counters.at("ears"), 0);
  EXPECT_GE(solution.counters.at("flips"), solution.counters.at("ears"));
  ASSERT_EQ(context.phases.size(), 2U);
}

}  // namespace

}  // namespace mwt
