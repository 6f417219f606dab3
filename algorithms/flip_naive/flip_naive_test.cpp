#include "algorithms/flip_naive/flip_naive.h"

#include "algorithms/common/testing/instances.h"
#include "algorithms/sweep/sweep.h"
#include "base/error.h"
#include "geometry/mesh/flip_triangulation.h"
#include "geometry/weight.h"

namespace mwt {
namespace {

// Figures 7 to 11 of the source report. It prints perimeters but no coordinates; these were recovered from the 15
// perimeters listed there, which they match to all four decimals.
const std::vector<Point> kFigurePoints = {
    {0.232231, 0.378795}, {0.072356, 0.793954}, {0.772162, 0.159266}, {0.582166, 0.000000}, {0.792049, 0.146730},
    {0.321352, 0.034372}, {0.300721, 0.685299}, {0.000000, 0.550305}, {0.640103, 0.027961}, {0.512016, 0.636257}};
const Triangulation kFigureStart = {10,
                                    {{9, 2, 4},
                                     {5, 0, 7},
                                     {0, 2, 9},
                                     {6, 1, 7},
                                     {0, 6, 7},
                                     {1, 6, 9},
                                     {6, 0, 9},
                                     {0, 8, 2},
                                     {2, 8, 4},
                                     {5, 8, 0},
                                     {5, 8, 3}}};

Triangulation counter_clockwise(Points points, Triangulation triangulation) {
  for (Triangle& t : triangulation.triangles) {
    if (orientation(points[t[0]], points[t[1]], points[t[2]]) < 0) std::swap(t[1], t[2]);
  }
  return triangulation;
}

// Claim C9.
TEST(FlipNaive, ReproducesTheReportsFigures) {
  const Triangulation start = counter_clockwise(kFigurePoints, kFigureStart);
  ASSERT_FALSE(find_violation(kFigurePoints, start).has_value());
  for (const char* improvement : {"first", "best"}) {
    SCOPED_TRACE(improvement);
    Context context = test::context_for(flip_naive_entry(), {{"start", "figure.csv"}, {"improvement", improvement}});
    context.start = start;
    const Solution solution = flip_naive_entry().function(kFigurePoints, context);
    ASSERT_EQ(solution.flips.size(), 2U);
    EXPECT_EQ(solution.flips[0].removed, (Edge{0, 8}));
    EXPECT_EQ(solution.flips[0].added, (Edge{2, 5}));
    EXPECT_EQ(solution.flips[1].removed, (Edge{5, 8}));
    EXPECT_EQ(solution.flips[1].added, (Edge{2, 3}));
    const double first = perimeter_sum(kFigurePoints, start).middle();
    const double last = perimeter_sum(kFigurePoints, solution.triangulation).middle();
    EXPECT_NEAR(first, 11.0751, 5e-5);
    EXPECT_NEAR(first - 2 * solution.flips[0].gain, 10.9347, 5e-5);
    EXPECT_NEAR(last, 10.7929, 5e-5);
    EXPECT_NEAR(last, first - 2 * solution.flips[0].gain - 2 * solution.flips[1].gain, 1e-14);
  }
}

TEST(FlipNaive, StopsAfterTheWantedNumberOfFlips) {
  const Triangulation start = counter_clockwise(kFigurePoints, kFigureStart);
  for (const std::string improvement : {"first", "best"}) {
    for (const std::size_t most : {0U, 1U, 2U, 3U}) {
      Context context =
          test::context_for(flip_naive_entry(), {{"improvement", improvement}, {"max_flips", std::to_string(most)}});
      context.start = start;
      const Solution solution = flip_naive_entry().function(kFigurePoints, context);
      EXPECT_EQ(solution.flips.size(), std::min<std::size_t>(most, 2));
      EXPECT_FALSE(find_violation(kFigurePoints, solution.triangulation).has_value());
      if (most > 0) continue;
      EXPECT_EQ(canonical_triangles(solution.triangulation), canonical_triangles(start));
    }
  }
  Context context = test::context_for(flip_naive_entry(), {{"max_flips", "-2"}});
  EXPECT_THROW(flip_naive_entry().function(kFigurePoints, context), InputError);
}

TEST(FlipNaive, IsValidOnAllShapesFromAllStarts) {
  for (const char* improvement : {"first", "best"}) {
    test::expect_valid_on_all_shapes(flip_naive_entry(), 1000, {{"improvement", improvement}});
    test::expect_valid_on_all_shapes(flip_naive_entry(), 100, {{"start", "sweep"}, {"improvement", improvement}});
    test::expect_valid_on_all_shapes(flip_naive_entry(), 10, {{"start", "greedy"}, {"improvement", improvement}});
  }
}

TEST(FlipNaive, EndsAtALocalOptimumAndEveryFlipGains) {
  for (const test::Instance& instance : test::instances(100)) {
    for (const char* improvement : {"first", "best"}) {
      SCOPED_TRACE(instance.name + " " + improvement);
      const Points points = instance.points;
      const Solution solution =
          test::solve_checked(flip_naive_entry(), points, {{"start", "sweep"}, {"improvement", improvement}});
      for (const Flip& flip : solution.flips) {
        EXPECT_GT(flip.gain, 0);
        EXPECT_LT(
            compare_length(points[flip.added.a], points[flip.added.b], points[flip.removed.a], points[flip.removed.b]),
            0);
      }
      const FlipTriangulation end(solution.triangulation);
      for (Index e = 0; e < end.edge_count(); ++e) {
        if (!is_flippable(points, end, e)) continue;
        const auto [a, b, c, d] = end.quadrilateral(e);
        EXPECT_GE(compare_length(points[c], points[d], points[a], points[b]), 0);
      }
    }
  }
}

TEST(FlipNaive, BestTakesTheLargestGainFirst) {
  const std::vector<Point> points = test::uniform_points(60, 4);
  const Solution solution =
      test::solve_checked(flip_naive_entry(), points, {{"start", "sweep"}, {"improvement", "best"}});
  const FlipTriangulation start(test::solve_checked(sweep_entry(), points).triangulation);
  double largest = 0;
  for (Index e = 0; e < start.edge_count(); ++e) {
    if (!is_flippable(points, start, e)) continue;
    const auto [a, b, c, d] = start.quadrilateral(e);
    largest = std::max(largest, (length(points[a], points[b]) - length(points[c], points[d])).high);
  }
  ASSERT_FALSE(solution.flips.empty());
  EXPECT_EQ(solution.flips.front().gain, largest);
}

TEST(FlipNaive, FirstVisitsEdgesByTheirIndices) {
  const std::vector<Point> points = test::uniform_points(60, 4);
  const Solution solution = test::solve_checked(flip_naive_entry(), points, {{"start", "sweep"}});
  const FlipTriangulation start(test::solve_checked(sweep_entry(), points).triangulation);
  Edge smallest{kNoIndex, kNoIndex};
  for (Index e = 0; e < start.edge_count(); ++e) {
    if (!is_flippable(points, start, e)) continue;
    const auto [a, b, c, d] = start.quadrilateral(e);
    if (compare_length(points[c], points[d], points[a], points[b]) < 0) smallest = std::min(smallest, start.edge(e));
  }
  ASSERT_FALSE(solution.flips.empty());
  EXPECT_EQ(solution.flips.front().removed, smallest);
}

TEST(FlipNaive, StopsAtTheDeadlineWithAValidTriangulation) {
  const std::vector<Point> points = test::uniform_points(500, 8);
  for (const char* improvement : {"first", "best"}) {
    Context context = test::context_for(flip_naive_entry(), {{"start", "sweep"}, {"improvement", improvement}});
    context.deadline = Context::Clock::now();
    const Solution solution = flip_naive_entry().function(points, context);
    EXPECT_EQ(solution.stop_reason, StopReason::deadline);
    EXPECT_FALSE(find_violation(points, solution.triangulation).has_value());
  }
}

TEST(FlipNaive, UnknownStartsAreRefused) {
  const std::vector<Point> points = test::report_example();
  Context context = test::context_for(flip_naive_entry(), {{"start", "nowhere"}});
  EXPECT_THROW(flip_naive_entry().function(points, context), InputError);
}

}  // namespace
}  // namespace mwt
