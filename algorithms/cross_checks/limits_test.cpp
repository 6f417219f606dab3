// Algorithms of polynomial but high degree, or of exponential time, stop at the deadline and at the memory they are
// given.

#include <gtest/gtest.h>

#include "algorithms/common/testing/solver_testing.h"
#include "base/cpu_clock.h"
#include "generators/registry.h"

namespace mwt {
namespace {

// Without a limit each takes at least ten times as long as LimitedRun allows, or much more memory.
struct Case {
  std::string algorithm;
  std::vector<Point> points;
  std::map<std::string, std::string> parameters;
};

std::vector<Point> with_inner_point(std::vector<Point> convex) {
  convex.push_back({0.001, 0.002});
  return convex;
}

std::vector<Case> long_cases() {
  return {
      {"polygon_dp", generate("circle", 20000, 1), {}},
      {"exact", generate("circle", 20000, 1), {}},
      {"hull_insertion", with_inner_point(generate("circle", 20000, 1)), {}},
      {"two_chains", generate("greedy_corridor", 60000, 1), {}},
      {"triangle_lp", generate("uniform", 1500, 1), {{"max_points", "1500"}}},
      {"triangle_lp", generate("wheel", 150, 1), {}},
      {"subset_dp", generate("uniform", 24, 1), {{"max_points", "24"}}},
      {"brute_force", generate("uniform", 16, 1), {{"max_points", "16"}}},
      {"boolean_model", generate("uniform", 24, 1), {{"count", "on"}}},
      {"greedy_naive", generate("uniform", 10000, 1), {}},
      {"greedy_naive", generate("circle", 6000, 1), {}},
      {"flip_naive", generate("uniform", 10000, 1), {{"start", "greedy"}}},
  };
}

Solution checked(const Case& what, Context& context) {
  const AlgorithmInfo& info = find_algorithm(what.algorithm);
  context.parameters = Parameters(info.name, info.parameters, what.parameters);
  Solution solution = info.function(what.points, context);
  const auto violation = find_violation(what.points, solution.triangulation);
  EXPECT_FALSE(violation) << violation->message;
  if (info.exactness == Exactness::exact && !solution.optimum) ADD_FAILURE() << "no bounds";
  if (solution.optimum) {
    EXPECT_GT(solution.optimum->lower, 0);
    EXPECT_LE(solution.optimum->lower, solution.optimum->upper);
    EXPECT_EQ(solution.optimum->upper, weight(what.points, solution.triangulation).upper);
  }
  return solution;
}

// CPU time of one thread is at most wall time: other load on the machine makes this easier to pass, not harder.
TEST(Limits, StopAtTheDeadline) {
  constexpr double kLimit = 0.1;
  constexpr double kOverrun = 1.2;  // .2 s of it are heuristics' own time; the rest is for slow machines
  for (const Case& what : long_cases()) {
    SCOPED_TRACE(what.algorithm);
    Context context;
    const double begin = process_cpu_time_s();
    context.deadline = Context::Clock::now() + std::chrono::milliseconds(static_cast<int>(1000 * kLimit));
    const Solution solution = checked(what, context);
    EXPECT_LT(process_cpu_time_s() - begin, kLimit + kOverrun);
    EXPECT_EQ(solution.stop_reason, StopReason::deadline);
  }
}

TEST(Limits, StopAtTheMemory) {
  const std::vector<Case> cases = {
      {"polygon_dp", generate("circle", 3000, 1), {}},
      {"exact", generate("circle", 3000, 1), {}},
      {"hull_insertion", with_inner_point(generate("circle", 3000, 1)), {}},
      {"two_chains", generate("greedy_corridor", 4000, 1), {}},
      {"triangle_lp", generate("uniform", 150, 1), {}},
      {"subset_dp", generate("circle", 18, 1), {{"max_points", "18"}}},
      {"greedy_naive", generate("uniform", 1000, 1), {}},
  };
  for (const Case& what : cases) {
    SCOPED_TRACE(what.algorithm);
    Context context;
    context.memory_bytes = 100'000;
    EXPECT_EQ(checked(what, context).stop_reason, StopReason::memory);
  }
}

}  // namespace
}  // namespace mwt
