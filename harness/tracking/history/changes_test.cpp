#include "harness/tracking/history/changes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/io/testing/folder_testing.h"
#include "harness/tracking/history/history.h"
#include "harness/tracking/result_set.h"
#include "harness/tracking/testing/synthetic_nightly_runs.h"

namespace mwt {
namespace {

using testing::SyntheticStudy;
using testing::TestFolder;

std::vector<NightlyRun> synthetic_nightly_runs(int count, std::uint64_t seed, const testing::Tamper& tamper = {},
                                               const SyntheticStudy& study = {}) {
  std::vector<NightlyRun> nightly_runs;
  for (int nightly_run = 0; nightly_run < count; ++nightly_run) {
    const ResultSet results{
        "", testing::synthetic_runs(study, nightly_run, seed, tamper), {testing::synthetic_environment()}};
    for (NightlyRun& one : nightly_runs_of(results)) nightly_runs.push_back(std::move(one));
  }
  return nightly_runs;
}

// 40 nightly runs, in times noise of 3%; from nightly run 25 on (counted from 0) one algorithm takes 10% longer,
// another a fifth more memory, a third is a tenth of a percent heavier on one family; and one nightly run everything
// takes half as long again.
void make_worse(int nightly_run, RunRecord& run, RandomEngine&) {
  if (nightly_run == 13) *run.wall_time_s *= 1.5;
  if (nightly_run < 25) return;
  if (run.algorithm == "greedy") *run.wall_time_s *= 1.10;
  if (run.algorithm == "patch") *run.peak_rss_bytes += 2'000'000;
  if (run.algorithm == "flip" && run.generator == "uniform") {
    for (auto* value : {&run.weight_lower, &run.weight_upper, &run.alpha_lower, &run.alpha_upper}) **value *= 1.001;
  }
}

/// Where noise hides some of an algorithm's steps, the others may place the change a nightly run too early or too late.
void expect_exactly_the_three(std::vector<Change> changes, const std::vector<NightlyRun>& nightly_runs,
                              std::size_t misplaced = 0) {
  ASSERT_EQ(changes.size(), 3u);
  std::ranges::sort(changes, {}, &Change::algorithm);
  const std::vector<std::string> algorithms = {"flip", "greedy", "patch"};
  const std::vector<Aspect> aspects = {Aspect::quality, Aspect::time, Aspect::memory};
  const std::vector<double> factors = {1.001, 1.10, 1.20};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t first = changes[i].nightly_run;
    EXPECT_EQ(changes[i].algorithm, algorithms[i]);
    EXPECT_EQ(changes[i].aspect, aspects[i]);
    EXPECT_NEAR(static_cast<double>(first), 25, aspects[i] == Aspect::time ? static_cast<double>(misplaced) : 0);
    EXPECT_TRUE(changes[i].is_regression);
    EXPECT_NEAR(changes[i].factor, factors[i], 0.03);
    EXPECT_EQ(nightly_runs[first].git_commit, testing::synthetic_commit(static_cast<int>(first)));
    EXPECT_EQ(changes[i].previous_nightly_run, first - 1);
  }
  EXPECT_LE(changes[1].lower, factors[1] + 0.01);
  EXPECT_GE(changes[1].upper, factors[1] - 0.01);
  EXPECT_LT(changes[1].lower, changes[1].factor);
}

TEST(Changes, FortyNightsWithThreeRegressionsASpikeAndNoise) {
  const TestFolder folder;
  for (int nightly_run = 0; nightly_run < 40; ++nightly_run) {
    const std::string results = folder.path(std::to_string(nightly_run));
    testing::write_synthetic_nightly_run(results, testing::synthetic_runs({}, nightly_run, 1, make_worse));
    History history(folder.path("history.sqlite"), History::Mode::write);
    for (const NightlyRun& one : nightly_runs_of(read_results(results)))
      EXPECT_EQ(history.add(one), History::Added::as_new);
  }
  const std::vector<NightlyRun> nightly_runs =
      History(folder.path("history.sqlite"), History::Mode::read).nightly_runs();
  ASSERT_EQ(nightly_runs.size(), 40u);
  const std::vector<Change> changes = find_changes(nightly_runs);
  expect_exactly_the_three(changes, nightly_runs);
  EXPECT_EQ(describe(changes[0], nightly_runs),
            "2026-01-26 regression flip: quality +0.100000% on uniform n=100, uniform n=1000 (cccccccccc..cccccccccc)");
}

TEST(Changes, ExactlyTheThreeWhateverTheNoise) {
  for (std::uint64_t seed = 2; seed < 12; ++seed) {
    const std::vector<NightlyRun> nightly_runs = synthetic_nightly_runs(40, seed, make_worse);
    expect_exactly_the_three(find_changes(nightly_runs), nightly_runs, 2);
  }
}

TEST(Changes, NothingInStableNights) {
  for (std::uint64_t seed = 100; seed < 110; ++seed)
    EXPECT_TRUE(find_changes(synthetic_nightly_runs(40, seed)).empty()) << seed;
}

TEST(Changes, ABusyMachineDoesNotFakeAChange) {
  const auto busy = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (nightly_run < 15) return;
    *run.wall_time_s *= 1.8;
    *run.delaunay_time_s *= 1.8;
  };
  EXPECT_TRUE(find_changes(synthetic_nightly_runs(40, 1, busy)).empty());
}

TEST(Changes, WithoutDelaunayTimesTimesAreTakenAsTheyAre) {
  SyntheticStudy study;
  study.has_delaunay_time = false;
  const std::vector<NightlyRun> nightly_runs = synthetic_nightly_runs(40, 1, make_worse, study);
  expect_exactly_the_three(find_changes(nightly_runs), nightly_runs);
}

TEST(Changes, ImprovementsAndFailures) {
  const auto change = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (nightly_run >= 20 && run.algorithm == "sweep") *run.wall_time_s *= 0.7;
    if (nightly_run >= 30 && run.algorithm == "exact" && run.n == 1000) {
      run.status = RunStatus::timeout;
      run.wall_time_s.reset();
    }
  };
  const std::vector<NightlyRun> nightly_runs = synthetic_nightly_runs(40, 1, change);
  const std::vector<Change> changes = find_changes(nightly_runs);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].algorithm, "sweep");
  EXPECT_FALSE(changes[0].is_regression);
  EXPECT_EQ(changes[0].nightly_run, 20u);
  EXPECT_EQ(changes[1].algorithm, "exact");
  EXPECT_EQ(changes[1].aspect, Aspect::failures);
  EXPECT_TRUE(changes[1].is_regression);
  EXPECT_EQ(changes[1].nightly_run, 30u);
  EXPECT_EQ(changes[1].factor, 1);
}

TEST(Changes, MachinesAreFollowedApart) {
  std::vector<NightlyRun> nightly_runs = synthetic_nightly_runs(30, 1);
  std::vector<NightlyRun> elsewhere =
      synthetic_nightly_runs(30, 2, [](int, RunRecord& run, RandomEngine&) { *run.wall_time_s *= 3; });
  for (NightlyRun& nightly_run : elsewhere) {
    nightly_run.environment = "other";
    nightly_runs.push_back(nightly_run);
  }
  EXPECT_TRUE(find_changes(nightly_runs).empty());
}

TEST(Changes, AMissingSeedMovesNothing) {
  std::vector<NightlyRun> nightly_runs = synthetic_nightly_runs(30, 1, [](int, RunRecord& run, RandomEngine&) {
    if (run.seed == 2) *run.wall_time_s *= 5;
  });
  for (std::size_t i = 10; i < nightly_runs.size(); ++i) {
    std::erase_if(nightly_runs[i].values, [](const NightlyValue& value) { return value.cell.seed == 2; });
  }
  EXPECT_TRUE(find_changes(nightly_runs).empty());
}

// Counts scatter by a hundred-thousandth; in the last of 20 nightly runs greedy has 1.2% more instructions.
void count(int nightly_run, RunRecord& run, RandomEngine& engine) {
  const double more = nightly_run == 19 && run.algorithm == "greedy" ? 1.012 : 1;
  run.callgrind_instructions = static_cast<std::uint64_t>(1e6 * more * (1 + 1e-5 * uniform_unit(engine)));
  run.callgrind_l1_misses = uniform_below(engine, 100);
}

TEST(Changes, OnePercentMoreInstructionsIsFoundTheNextMorning) {
  const std::vector<NightlyRun> nightly_runs = synthetic_nightly_runs(20, 1, count);
  const std::vector<Change> changes = find_changes(nightly_runs);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].algorithm, "greedy");
  EXPECT_EQ(changes[0].aspect, Aspect::counts);
  EXPECT_EQ(changes[0].nightly_run, 19u);
  EXPECT_NE(describe(changes[0], nightly_runs).find("regression greedy: counts x1.0120"), std::string::npos)
      << describe(changes[0], nightly_runs);
}

TEST(Changes, NothingInTwentyNightsOfEqualCounts) {
  EXPECT_TRUE(find_changes(synthetic_nightly_runs(19, 1, count)).empty());
}

}  // namespace
}  // namespace mwt
