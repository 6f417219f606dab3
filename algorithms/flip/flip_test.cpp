#include "algorithms/flip/flip.h"

#include <gtest/gtest.h>

#include "algorithms/common/start.h"
#include "algorithms/common/testing/instances.h"
#include "algorithms/greedy/greedy.h"
#include "base/error.h"
#include "geometry/checker.h"
#include "geometry/delaunay.h"
#include "geometry/testing/shapes.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

using test::context_for;
using test::make_shape;
using test::ShapeFamily;
using test::shapes;
using test::solve_checked;

TEST(Flip, EndsAtAValidLocalOptimumOnAllShapes) {
  for (const ShapeFamily& shape : shapes()) {
    for (const std::size_t n : {3, 4, 5, 10, 100, 1000}) {
      const std::vector<Point> points = make_shape(shape, n, n);
      for (const std::string start : {"delaunay", "sweep", "quadtree", "random"}) {
        for (const std::string order : {"stack", "best"}) {
          const Solution solution = solve_checked(flip_entry(), points, {{"start", start}, {"order", order}});
          const auto violation = find_violation(points, solution.triangulation);
          EXPECT_FALSE(violation) << shape.name << " n=" << n << ' ' << start << ": " << violation->message;
          EXPECT_TRUE(is_flip_optimal(PlanarMesh(points, solution.triangulation))) << shape.name << " n=" << n;
          EXPECT_FALSE(solution.stopped_early());
        }
      }
    }
  }
}

TEST(Flip, FindsNothingToDoOnGreedy) {
  for (const ShapeFamily& shape : shapes()) {
    for (const std::size_t n : {10, 100, 1000}) {
      const std::vector<Point> points = make_shape(shape, n, n + 1);
      for (const std::string order : {"stack", "best"}) {
        EXPECT_EQ(solve_checked(flip_entry(), points, {{"start", "greedy"}, {"order", order}}).counters.at("flips"), 0)
            << shape.name;
      }
    }
  }
}

TEST(Flip, IsNeverWorseThanItsStartAndSumsItsGains) {
  const std::vector<Point> points = make_shape(shapes().front(), 500, 1);
  Context context = context_for(flip_entry(), {{"start", "random"}, {"trace", "on"}});
  const double before = weight(points, start_mesh(points, context).triangulation()).middle();
  const Solution solution = flip_entry().function(points, context);
  ASSERT_EQ(static_cast<double>(solution.flips.size()), solution.counters.at("flips"));
  double gains = 0;
  for (const Flip& flip : solution.flips) {
    EXPECT_GE(flip.gain, 0);
    gains += flip.gain;
  }
  EXPECT_NEAR(before - gains, weight(points, solution.triangulation).middle(), 1e-9);
}

TEST(Flip, TellsGainsInTheUnitsOfThePoints) {
  std::vector<Point> points = make_shape(shapes().front(), 100, 1);
  const std::vector<Flip> flips = solve_checked(flip_entry(), points, {{"trace", "on"}}).flips;
  for (Point& p : points) p = {p.x * 0x1p900, p.y * 0x1p900};
  const std::vector<Flip> larger = solve_checked(flip_entry(), points, {{"trace", "on"}}).flips;
  ASSERT_EQ(larger.size(), flips.size());
  for (std::size_t i = 0; i < flips.size(); ++i) {
    EXPECT_EQ(larger[i].added, flips[i].added);
    EXPECT_NEAR(larger[i].gain * 0x1p-900, flips[i].gain, 1e-14);
  }
}

TEST(Flip, TakesTheLargestGainFirst) {
  const std::vector<Point> points = make_shape(shapes().front(), 300, 2);
  const Solution best = solve_checked(flip_entry(), points, {{"order", "best"}, {"trace", "on"}});
  ASSERT_FALSE(best.flips.empty());
  // The stack's first flip was possible at the start, so it gains no more.
  EXPECT_LE(solve_checked(flip_entry(), points, {{"trace", "on"}}).flips.front().gain, best.flips.front().gain);
  EXPECT_LE(weight(points, best.triangulation).upper,
            weight(points, solve_checked(flip_entry(), points, {}).triangulation).lower);
}

TEST(Flip, StartsFromHullInsertion) {
  const std::vector<Point> points = make_shape(shapes().front(), 300, 3);
  const Solution solution = solve_checked(flip_entry(), points, {{"start", "hull_insertion"}});
  EXPECT_FALSE(find_violation(points, solution.triangulation));
  EXPECT_GT(solution.counters.at("flips"), 0);
  EXPECT_TRUE(is_flip_optimal(PlanarMesh(points, solution.triangulation)));
}

TEST(Flip, StartsFromAGivenTriangulation) {
  const std::vector<Point> points = make_shape(shapes().front(), 200, 3);
  Context context = context_for(flip_entry(), {{"start", "mine.tri"}});
  EXPECT_THROW((void)flip_entry().function(points, context), InputError);
  context.start = greedy_triangulation(points);
  const Solution solution = flip_entry().function(points, context);
  EXPECT_EQ(edges_of(solution.triangulation), edges_of(*context.start));
}

TEST(Flip, IsDeterministicForASeed) {
  const std::vector<Point> points = make_shape(shapes().front(), 1000, 4);
  const auto edges = [&](std::uint64_t seed) {
    Context context = context_for(flip_entry(), {{"start", "random"}});
    context.seed = seed;
    return edges_of(flip_entry().function(points, context).triangulation);
  };
  EXPECT_EQ(edges(1), edges(1));
  EXPECT_NE(edges(1), edges(2));
}

TEST(Flip, StopsAtTheDeadline) {
  const std::vector<Point> points = make_shape(shapes().front(), 20000, 5);
  for (const std::string order : {"stack", "best"}) {
    Context context = context_for(flip_entry(), {{"start", "random"}, {"order", order}});
    context.deadline = Context::Clock::now();
    const Solution solution = flip_entry().function(points, context);
    EXPECT_EQ(solution.stop_reason, StopReason::deadline);
    EXPECT_FALSE(find_violation(points, solution.triangulation));
  }
}

}  // namespace

}  // namespace mwt
