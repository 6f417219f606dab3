#include "algorithms/common/lightest_heuristic.h"

#include <gtest/gtest.h>

#include "algorithms/common/testing/solver_testing.h"
#include "generators/registry.h"

namespace mwt {
namespace {

double upper_weight(Points points, const Triangulation& triangulation) { return weight(points, triangulation).upper; }

double weight_of(const std::string& algorithm, Points points) {
  return upper_weight(points, solve_and_check(algorithm, points).triangulation);
}

// On corridors greedy is far worse than flips, on rings it is far better.
TEST(LightestHeuristic, IsNeverHeavierThanAnyOfThem) {
  for (const char* family : {"uniform", "greedy_corridor", "flip_corridor", "annulus", "roads", "convex_position"}) {
    SCOPED_TRACE(family);
    const std::vector<Point> points = generate(family, 500, 1);
    const Triangulation own = solve_and_check("sweep", points).triangulation;
    for (const auto& start : {std::optional<Triangulation>(), std::optional(own)}) {
      const Triangulation lightest = lightest_heuristic(points, Context{}, start);
      EXPECT_FALSE(find_violation(points, lightest));
      for (const char* algorithm : {"greedy", "flip", "patch"}) {
        EXPECT_LE(upper_weight(points, lightest), weight_of(algorithm, points)) << algorithm;
      }
    }
  }
}

TEST(LightestHeuristic, KeepsTheOptimum) {
  const std::vector<Point> points = generate("wheel", 60, 1);
  const Triangulation optimum = solve_to_optimality("exact", points).triangulation;
  EXPECT_EQ(upper_weight(points, lightest_heuristic(points, Context{}, optimum)), upper_weight(points, optimum));
}

TEST(LightestHeuristic, ReturnsAValidTriangulationPastTheDeadline) {
  const std::vector<Point> points = generate("uniform", 3000, 1);
  Context context;
  context.deadline = Context::Clock::now();
  EXPECT_FALSE(find_violation(points, lightest_heuristic(points, context)));
  const Triangulation own = solve_and_check("greedy", points).triangulation;
  EXPECT_LE(upper_weight(points, lightest_heuristic(points, context, own)), upper_weight(points, own));
}

TEST(LightestHeuristic, GetsItsTimeBeforeTheDeadline) {
  EXPECT_FALSE(deadline_before_heuristics({}, 1000));
  EXPECT_FALSE(deadline_of_heuristics({}));
  const auto now = Context::Clock::now();
  const Deadline hour = now + std::chrono::hours(1), late = now - std::chrono::hours(1);
  EXPECT_LT(deadline_before_heuristics(hour, 1000).value(), hour.value());
  EXPECT_GT(deadline_before_heuristics(hour, 1000).value(), now + std::chrono::minutes(44));
  EXPECT_EQ(deadline_before_heuristics(late, 1000).value(), late.value());
  EXPECT_EQ(deadline_of_heuristics(hour).value(), hour.value());
  EXPECT_GT(deadline_of_heuristics(late).value(), now);
}

TEST(LightestHeuristic, DeadlinesKeepTheInterrupt) {
  const std::atomic<bool> interrupt = true;
  Deadline hour = Context::Clock::now() + std::chrono::hours(1), none;
  hour.interrupt = none.interrupt = &interrupt;
  for (const Deadline& deadline : {hour, none}) {
    EXPECT_TRUE(has_passed(deadline));
    EXPECT_TRUE(has_passed(deadline_before_heuristics(deadline, 1000)));
    EXPECT_TRUE(has_passed(deadline_before_bounds(deadline, 1000)));
    EXPECT_TRUE(has_passed(deadline_of_bounds(deadline, 1000)));
    EXPECT_TRUE(has_passed(deadline_of_heuristics(deadline)));
  }
}

}  // namespace
}  // namespace mwt
