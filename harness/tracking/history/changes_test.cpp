#include "harness/tracking/history/changes.h"

#include <gtest/gtest.h>

#include "harness/io/testing/folder_testing.h"
#include "harness/tracking/history/history.h"
#include "harness/tracking/result_set.h"
#include "harness/tracking/testing/synthetic_nights_testing.h"

namespace mwt {
namespace {

using testing::SyntheticStudy;
using testing::TestFolder;

std::vector<Night> synthetic_nights(int count, std::uint64_t seed, const testing::Tamper& tamper = {},
                                    const SyntheticStudy& study = {}) {
  std::vector<Night> nights;
  for (int night = 0; night < count; ++night) {
    const ResultSet results{
        "", testing::synthetic_runs(study, night, seed, tamper), {testing::synthetic_environment()}};
    for (Night& one : nights_of(results)) nights.push_back(std::move(one));
  }
  return nights;
}

// 40 nights, in times noise of 3%; from night 25 on (counted from 0) one algorithm takes 10% longer, another a fifth
// more memory, a third is a tenth of a percent heavier on one family; and one night everything takes half as long
// again.
void make_worse(int night, RunRecord& run, RandomEngine&) {
  if (night == 13) *run.wall_time_s *= 1.5;
  if (night < 25) return;
  if (run.algorithm == "greedy") *run.wall_time_s *= 1.10;
  if (run.algorithm == "patch") *run.peak_rss_bytes += 2'000'000;
  if (run.algorithm == "flip" && run.generator == "uniform") {
    for (auto* value : {&run.weight_lower, &run.weight_upper, &run.alpha_lower, &run.alpha_upper}) **value *= 1.001;
  }
}

void expect_exactly_the_three(const std::vector<Change>& changes, const std::vector<Night>& nights) {
  ASSERT_EQ(changes.size(), 3u);
  const std::vector<std::string> algorithms = {"flip", "greedy", "patch"};
  const std::vector<Aspect> aspects = {Aspect::quality, Aspect::time, Aspect::memory};
  const std::vector<double> factors = {1.001, 1.10, 1.20};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(changes[i].algorithm, algorithms[i]);
    EXPECT_EQ(changes[i].aspect, aspects[i]);
    EXPECT_EQ(changes[i].night, 25u);
    EXPECT_TRUE(changes[i].is_regression);
    EXPECT_NEAR(changes[i].factor, factors[i], 0.025);
    EXPECT_EQ(nights[changes[i].night].git_commit, testing::synthetic_commit(25));
    EXPECT_EQ(nights[changes[i].previous_night].git_commit, testing::synthetic_commit(24));
  }
}

TEST(Changes, FortyNightsWithThreeRegressionsASpikeAndNoise) {
  const TestFolder folder;
  for (int night = 0; night < 40; ++night) {
    const std::string results = folder.path(std::to_string(night));
    testing::write_synthetic_night(results, testing::synthetic_runs({}, night, 1, make_worse));
    History history(folder.path("history.sqlite"), History::Mode::write);
    for (const Night& one : nights_of(read_results(results))) EXPECT_EQ(history.add(one), History::Added::as_new);
  }
  const std::vector<Night> nights = History(folder.path("history.sqlite"), History::Mode::read).nights();
  ASSERT_EQ(nights.size(), 40u);
  const std::vector<Change> changes = find_changes(nights);
  expect_exactly_the_three(changes, nights);
  EXPECT_EQ(describe(changes[0], nights),
            "2026-01-26 regression flip: quality +0.100000% on uniform n=100, uniform n=1000 (cccccccccc..cccccccccc)");
}

TEST(Changes, ExactlyTheThreeWhateverTheNoise) {
  for (std::uint64_t seed = 2; seed < 12; ++seed) {
    const std::vector<Night> nights = synthetic_nights(40, seed, make_worse);
    expect_exactly_the_three(find_changes(nights), nights);
  }
}

TEST(Changes, NothingInStableNights) {
  for (std::uint64_t seed = 100; seed < 110; ++seed)
    EXPECT_TRUE(find_changes(synthetic_nights(40, seed)).empty()) << seed;
}

TEST(Changes, ABusyMachineDoesNotFakeAChange) {
  const auto busy = [](int night, RunRecord& run, RandomEngine&) {
    if (night < 15) return;
    *run.wall_time_s *= 1.8;
    *run.yardstick_time_s *= 1.8;
  };
  EXPECT_TRUE(find_changes(synthetic_nights(40, 1, busy)).empty());
}

TEST(Changes, WithoutYardstickTimesAreTakenAsTheyAre) {
  SyntheticStudy study;
  study.has_yardstick = false;
  const std::vector<Night> nights = synthetic_nights(40, 1, make_worse, study);
  expect_exactly_the_three(find_changes(nights), nights);
}

TEST(Changes, ImprovementsAndFailures) {
  const auto change = [](int night, RunRecord& run, RandomEngine&) {
    if (night >= 20 && run.algorithm == "sweep") *run.wall_time_s *= 0.7;
    if (night >= 30 && run.algorithm == "exact" && run.n == 1000) {
      run.status = RunStatus::timeout;
      run.wall_time_s.reset();
    }
  };
  const std::vector<Night> nights = synthetic_nights(40, 1, change);
  const std::vector<Change> changes = find_changes(nights);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].algorithm, "sweep");
  EXPECT_FALSE(changes[0].is_regression);
  EXPECT_EQ(changes[0].night, 20u);
  EXPECT_EQ(changes[1].algorithm, "exact");
  EXPECT_EQ(changes[1].aspect, Aspect::failures);
  EXPECT_TRUE(changes[1].is_regression);
  EXPECT_EQ(changes[1].night, 30u);
  EXPECT_EQ(changes[1].factor, 1);
}

TEST(Changes, MachinesAreFollowedApart) {
  std::vector<Night> nights = synthetic_nights(30, 1);
  std::vector<Night> elsewhere =
      synthetic_nights(30, 2, [](int, RunRecord& run, RandomEngine&) { *run.wall_time_s *= 3; });
  for (Night& night : elsewhere) {
    night.environment = "other";
    nights.push_back(night);
  }
  EXPECT_TRUE(find_changes(nights).empty());
}

TEST(Changes, AMissingSeedMovesNothing) {
  std::vector<Night> nights = synthetic_nights(30, 1, [](int, RunRecord& run, RandomEngine&) {
    if (run.seed == 2) *run.wall_time_s *= 5;
  });
  for (std::size_t i = 10; i < nights.size(); ++i) {
    std::erase_if(nights[i].values, [](const NightValue& value) { return value.cell.seed == 2; });
  }
  EXPECT_TRUE(find_changes(nights).empty());
}

}  // namespace
}  // namespace mwt
