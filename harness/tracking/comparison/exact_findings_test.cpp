#include "harness/tracking/comparison/exact_findings.h"

#include <gtest/gtest.h>

#include "harness/tracking/testing/synthetic_nightly_runs.h"

namespace mwt {
namespace {

RunRecord good_run() {
  RandomEngine engine = make_engine("exact_findings_test", 1);
  RunRecord run = testing::synthetic_run({}, "flip", engine);
  run.peak_rss_bytes = 20'000'000;
  return run;
}

std::vector<ExactFinding> findings(const std::vector<RunRecord>& base, const std::vector<RunRecord>& now) {
  std::vector<const RunRecord*> before, after;
  for (const RunRecord& run : base) before.push_back(&run);
  for (const RunRecord& run : now) after.push_back(&run);
  return exact_findings(cell_of(base.front()), before, after, 0.05);
}

TEST(ExactFindings, EqualRunsGiveNone) { EXPECT_TRUE(findings({good_run()}, {good_run(), good_run()}).empty()); }

TEST(ExactFindings, TheSmallestCertifiedDifferenceOfWeightsCounts) {
  RunRecord heavier = good_run();
  heavier.weight_lower = heavier.weight_upper = next_up(*heavier.weight_upper);
  heavier.alpha_lower = heavier.alpha_upper = next_up(*heavier.alpha_upper);
  const auto worse = findings({good_run()}, {heavier});
  ASSERT_EQ(worse.size(), 1u);
  EXPECT_EQ(worse[0].aspect, Aspect::quality);
  EXPECT_TRUE(worse[0].is_regression);
  EXPECT_EQ(worse[0].text, "alpha 1.04 -> 1.0400000000000003");
  const auto better = findings({heavier}, {good_run()});
  ASSERT_EQ(better.size(), 1u);
  EXPECT_FALSE(better[0].is_regression);
}

TEST(ExactFindings, WeightsThatMayBeEqualAreNoChange) {
  RunRecord wider = good_run();
  wider.weight_upper = *wider.weight_upper + 1e-12;
  EXPECT_TRUE(findings({good_run()}, {wider}).empty());
}

TEST(ExactFindings, StoppedEarlySaysNothingAboutQuality) {
  RunRecord stopped = good_run();
  stopped.stopped_early = true;
  stopped.weight_lower = stopped.weight_upper = 1000;
  for (const ExactFinding& finding : findings({good_run()}, {stopped})) EXPECT_NE(finding.aspect, Aspect::quality);
}

TEST(ExactFindings, RunsThatAreStoppedEarlyNowAreARegression) {
  RunRecord stopped = good_run();
  stopped.stopped_early = true;
  const auto found = findings({good_run(), good_run()}, {stopped, good_run()});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_regression);
  EXPECT_TRUE(found[0].depends_on_speed);
  EXPECT_EQ(found[0].text, "runs that did not end by themselves: none -> 1 of 2 (stopped early)");
}

// Neither a failure nor a time nor a weight is left of it.
TEST(ExactFindings, AnInstanceThatIsDeclinedNowIsARegression) {
  RunRecord declined = good_run();
  declined.status = RunStatus::not_applicable;
  const auto found = findings({good_run()}, {declined});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_regression);
  EXPECT_FALSE(found[0].depends_on_speed);
  EXPECT_TRUE(findings({declined}, {declined}).empty());
}

TEST(ExactFindings, OnlyTimeLimitsDependOnTheMachinesLoad) {
  RunRecord late = good_run(), broken = good_run();
  late.status = RunStatus::timeout;
  broken.status = RunStatus::crashed;
  EXPECT_TRUE(findings({good_run()}, {late})[0].depends_on_speed);
  EXPECT_FALSE(findings({good_run()}, {late, broken})[0].depends_on_speed);
}

TEST(ExactFindings, WithoutAProvedOptimumTheWeightIsTold) {
  RunRecord base = good_run(), now = good_run();
  base.optimality = now.optimality = "bounded";
  now.weight_lower = now.weight_upper = 105;
  const auto found = findings({base}, {now});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].text, "weight 104 -> 105");
}

TEST(ExactFindings, AnOptimumThatIsNotProvedAnyMoreIsARegression) {
  RunRecord now = good_run();
  now.optimality = "bounded";
  const auto found = findings({good_run()}, {now});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_regression);
  EXPECT_TRUE(findings({good_run()}, {now, good_run()}).empty()) << "one of them proved it";
}

TEST(ExactFindings, FailuresBySharesOfRuns) {
  RunRecord failed = good_run();
  failed.status = RunStatus::timeout;
  const auto worse = findings({good_run()}, {failed, good_run()});
  ASSERT_EQ(worse.size(), 1u);
  EXPECT_TRUE(worse[0].is_regression);
  EXPECT_EQ(worse[0].text, "failed runs: none -> 1 of 2 (timeout)");
  EXPECT_TRUE(findings({failed}, {failed, failed}).empty());
  EXPECT_FALSE(findings({failed}, {failed, good_run()})[0].is_regression);
}

TEST(ExactFindings, MemoryMustGrowClearlyInEveryRun) {
  RunRecord more = good_run();
  *more.peak_rss_bytes += 6'000'000;
  ASSERT_EQ(findings({good_run()}, {more, more}).size(), 1u);
  EXPECT_EQ(findings({good_run()}, {more})[0].aspect, Aspect::memory);
  EXPECT_TRUE(findings({good_run()}, {more, good_run()}).empty());
  RunRecord little_more = good_run();
  *little_more.peak_rss_bytes += 3'000'000;
  EXPECT_TRUE(findings({good_run()}, {little_more}).empty());
  EXPECT_FALSE(findings({more}, {good_run()})[0].is_regression);
}

RunRecord counted_run(std::uint64_t instructions) {
  RunRecord run = good_run();
  run.callgrind_instructions = instructions;
  return run;
}

TEST(ExactFindings, OnePercentMoreInstructionsIsARegression) {
  const auto more =
      findings({counted_run(1'000'000), counted_run(1'000'010)}, {counted_run(1'010'020), counted_run(1'010'030)});
  ASSERT_EQ(more.size(), 1u);
  EXPECT_EQ(more[0].aspect, Aspect::counts);
  EXPECT_TRUE(more[0].is_regression && more[0].is_confirmed);
  EXPECT_EQ(more[0].text, "callgrind_instructions 1000005 -> 1010025 (x1.0100)");
  const auto fewer =
      findings({counted_run(1'010'030), counted_run(1'010'030)}, {counted_run(1'000'000), counted_run(1'000'010)});
  ASSERT_EQ(fewer.size(), 1u);
  EXPECT_FALSE(fewer[0].is_regression);
}

TEST(ExactFindings, LessThanOnePercentIsNothing) {
  EXPECT_TRUE(findings({counted_run(1'000'000)}, {counted_run(1'009'999)}).empty());
  EXPECT_TRUE(
      findings({counted_run(1'000'000), counted_run(1'008'000)}, {counted_run(1'012'000), counted_run(1'019'000)})
          .empty())
      << "every run must have more than every other";
  EXPECT_TRUE(findings({good_run()}, {counted_run(1'000'000)}).empty()) << "only one side was counted";
}

TEST(ExactFindings, OneCountedRunConfirmsNothing) {
  const auto more = findings({counted_run(1'000'000), counted_run(1'000'000)}, {counted_run(1'200'000), good_run()});
  ASSERT_EQ(more.size(), 1u);
  EXPECT_TRUE(more[0].is_regression);
  EXPECT_FALSE(more[0].is_confirmed);
}

TEST(ExactFindings, HardwareCountsServeWhereCallgrindIsMissing) {
  RunRecord few = good_run(), many = good_run();
  few.instructions = 1'000'000;
  many.instructions = 1'100'000;
  const auto found = findings({few, few}, {many, many});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].text, "instructions 1000000 -> 1100000 (x1.1000)");
}

TEST(ExactFindings, TheFunctionThatChangedMostIsNamed) {
  const RunRecord before = counted_run(1000), after = counted_run(1100);
  const Profiles profiles = {[](const RunRecord&) {
                               return FunctionCounts{{"mwt::f(int)", 500}, {"g", 500}};
                             },
                             [](const RunRecord&) {
                               return FunctionCounts{{"mwt::f(int)", 600}, {"g", 500}};
                             }};
  const auto found = exact_findings(cell_of(before), {&before}, {&after}, 0.05, profiles);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].text, "callgrind_instructions 1000 -> 1100 (x1.1000), most in f +20.0%");
}

}  // namespace
}  // namespace mwt
