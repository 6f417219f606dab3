#include "harness/run/execution.h"

#include <gtest/gtest.h>

#include "geometry/checker.h"
#include "harness/run/machine/peak_memory.h"
#include "harness/run/testing/algorithms_testing.h"

namespace mwt {
namespace {

Instance uniform_instance(Index n) { return make_instance(generate("uniform", n, 1), "test"); }

Request request_for(const AlgorithmInfo& info) {
  Request request;
  request.algorithm = &info;
  request.parameters = Parameters(info.name, info.parameters, {});
  return request;
}

TEST(Execution, OneExecutionIsMeasured) {
  const Instance instance = uniform_instance(2000);
  const AlgorithmInfo well = testing::entry("well", testing::solve_well);
  const Execution execution = execute_once(request_for(well), instance.set.points);
  EXPECT_GT(execution.wall_time_s, 0);
  EXPECT_GT(execution.peak_rss_bytes, std::uint64_t{1} << 20);
  EXPECT_EQ(execution.iterations, 1u);
  EXPECT_FALSE(find_violation(instance.set.points, execution.solution.triangulation));
}

TEST(Execution, ShortRunsAreRepeatedAndLongOnesAreNot) {
  const Instance instance = uniform_instance(10);
  const AlgorithmInfo well = testing::entry("well", testing::solve_well);
  EXPECT_GT(execute_repeatedly(request_for(well), instance.set.points, 0.01).iterations, 5u);
  const AlgorithmInfo slow = testing::entry("slow", [](Points points, Context& context) {
    usleep(30000);
    return testing::solve_well(points, context);
  });
  const Execution once = execute_repeatedly(request_for(slow), instance.set.points, 0.003);
  EXPECT_EQ(once.iterations, 1u);
  EXPECT_GE(once.wall_time_s, 0.03);
  EXPECT_LT(once.cpu_time_s, 0.02);
}

TEST(Execution, RepetitionDoesNotAddToThePeakOfMemory) {
  if (!testing::kUsualAllocator) GTEST_SKIP() << "freed memory is kept";
  const Instance instance = uniform_instance(10);
  const AlgorithmInfo large = testing::entry("large", [](Points, Context&) {
    Solution solution;
    solution.count.emplace(std::size_t{1} << 24, '7');
    return solution;
  });
  // The first solution is released before the second is made.
  const std::uint64_t once = execute_once(request_for(large), instance.set.points).peak_rss_bytes;
  const Execution repeated = execute_repeatedly(request_for(large), instance.set.points, 0.3);
  EXPECT_GT(repeated.iterations, 1u);
  EXPECT_LT(repeated.peak_rss_bytes, once + (std::uint64_t{1} << 23));
}

TEST(Execution, AlgorithmsThatMayNeedItGetToKnowHowMuchMemoryThereIs) {
  static bool has_limit = false;
  AlgorithmInfo info = testing::entry("looks", [](Points points, Context& context) {
    has_limit = context.memory_bytes.has_value();
    return testing::solve_well(points, context);
  });
  for (const auto& [n, exactness, expected] : {std::tuple(Index{100}, Exactness::heuristic, false),
                                               {Index{100}, Exactness::exact, true},
                                               {Index{2000}, Exactness::heuristic, true}}) {
    info.exactness = exactness;
    static_cast<void>(solve_unmeasured(request_for(info), uniform_instance(n).set.points));
    EXPECT_EQ(has_limit, expected) << n;
  }
}

TEST(Execution, WhatAnAlgorithmThrowsComesOut) {
  const Instance instance = uniform_instance(10);
  const AlgorithmInfo declines = testing::entry("declines", testing::decline);
  EXPECT_THROW(static_cast<void>(execute_once(request_for(declines), instance.set.points)), NotApplicable);
  EXPECT_THROW(static_cast<void>(execute_repeatedly(request_for(declines), instance.set.points, 0.01)), NotApplicable);
}

TEST(Execution, TheDeadlineBeginsWithTheExecution) {
  const Instance instance = uniform_instance(10);
  const AlgorithmInfo patient = testing::entry("patient", [](Points points, Context& context) {
    while (!context.deadline_passed()) usleep(1000);
    Solution solution = testing::solve_well(points, context);
    solution.stop_reason = StopReason::deadline;
    return solution;
  });
  Request request = request_for(patient);
  request.time_limit_s = 0.05;
  const Execution execution = execute_repeatedly(request, instance.set.points, 0.001);
  EXPECT_EQ(execution.solution.stop_reason, StopReason::deadline);
  EXPECT_GE(execution.wall_time_s, 0.05);
}

TEST(Execution, PhasesAreThoseOfOneExecution) {
  const Instance instance = uniform_instance(10);
  const AlgorithmInfo phased = testing::entry("phased", [](Points points, Context& context) {
    const ScopedPhase phase(context, "all");
    return testing::solve_well(points, context);
  });
  EXPECT_EQ(execute_repeatedly(request_for(phased), instance.set.points, 0.01).phases.size(), 1u);
}

TEST(PeakMemory, IsThatOfTheStretch) {
  if (!testing::kUsualAllocator) GTEST_SKIP() << "freed memory is kept";
  reset_peak_memory();
  const std::uint64_t before = peak_memory_bytes();
  { const std::vector<char> block(std::size_t{1} << 26, 'x'); }
  EXPECT_GE(peak_memory_bytes(), before + (std::uint64_t{1} << 25));
  reset_peak_memory();
  EXPECT_LT(peak_memory_bytes(), before + (std::uint64_t{1} << 25));
}

}  // namespace
}  // namespace mwt
