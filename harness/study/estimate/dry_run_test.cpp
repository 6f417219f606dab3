#include "harness/study/estimate/dry_run.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "base/error.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/run/testing/algorithms_testing.h"
#include "harness/study/estimate/estimate.h"

namespace mwt {
namespace {

using testing::TestFolder;

Study small_study() {
  Study study;
  study.name = "s";
  study.summary = "for tests";
  study.families = {{"uniform", {}, {}, {}, "s.toml:1"}};
  study.algorithms = {{"well", {}, {}, "s.toml:2"}, {"small", {}, {}, "s.toml:2"}};
  study.sizes = {5, 20};
  study.seeds = {1, 2, 3};
  study.min_time_s = 0.001;
  study.limits.time_s = 8;
  study.limits.grace_s = 2;
  study.seeks_optimum = false;
  return study;
}

TEST(DryRun, SaysWhatWouldBeDoneAndDoesNothing) {
  const TestFolder folder;
  std::ostringstream out;
  RunOptions options;
  options.folder = folder.path("out");
  dry_run(small_study(), testing::test_catalogue(), options, out);
  const std::string text = out.str();
  for (const char* part : {"6 instances, 12 runs", "uniform          6  5 20  1 2 3", "small         3          5",
                           "with every run and search at its limit 90.1 s", "nothing was recorded"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path("out")));
}

TEST(DryRun, RefusesWhatARunWould) {
  Study study = small_study();
  study.optimum_sources = {{"well", {}, "s.toml:9"}};
  std::ostringstream out;
  EXPECT_THROW(dry_run(study, testing::test_catalogue(), {}, out), InputError);
}

TEST(Estimate, RecordedTimesTellTheLikelyOne) {
  const Study study = small_study();
  const Catalogue catalogue = testing::test_catalogue();
  const Plan plan = make_plan(study, catalogue);
  const std::vector<PlannedWork> work = planned_work(study, catalogue, plan);
  ASSERT_EQ(work.size(), 3u) << "well at two sizes, small at one";
  TimeModel model;
  model.add({"well", "uniform", 20}, {2, false, true});
  model.add({"well", "uniform", 5}, {1, false, true});
  model.add({"small", "uniform", 5}, {1, false, true});
  const DurationEstimate estimate = estimate_duration(study, plan, work, model);
  EXPECT_NEAR(estimate.likely, 12, 0.1) << "three seeds";
  EXPECT_LT(estimate.low, 12);
  EXPECT_GT(estimate.high, 12);
  EXPECT_EQ(estimate.runs.at(TimeBasis::recorded).count, 9u);
  EXPECT_EQ(estimate.runs.size(), 1u);
  EXPECT_NEAR(estimate.most, 90, 0.1);
}

TEST(Estimate, WithoutRecordsACalibrationMeasures) {
  const Study study = small_study();
  const Catalogue catalogue = testing::test_catalogue();
  const Plan plan = make_plan(study, catalogue);
  const std::vector<PlannedWork> work = planned_work(study, catalogue, plan);
  TimeModel model;
  EXPECT_GE(calibrate(model, study, plan, work, 60), 2u);
  const DurationEstimate estimate = estimate_duration(study, plan, work, model);
  EXPECT_FALSE(estimate.runs.contains(TimeBasis::nothing));
  EXPECT_LT(estimate.likely, estimate.most) << "Delaunay triangulations of 20 points take no 10 s";
}

TEST(Estimate, SearchesCountWithTheirOwnLimit) {
  Study study = small_study();
  study.seeks_optimum = true;
  study.optimum_sources = {{"weak_bound", {}, ""}};
  study.optimum_limits = {3, 1, study.limits.memory_bytes};
  const Catalogue catalogue = testing::test_catalogue();
  const Plan plan = make_plan(study, catalogue);
  const DurationEstimate estimate = estimate_duration(study, plan, planned_work(study, catalogue, plan), {});
  EXPECT_EQ(estimate.searches.count, 6u);
  EXPECT_NEAR(estimate.most, 9 * 10 + 6 * 4, 0.2);
  EXPECT_NEAR(estimate.likely, estimate.most, 0.2) << "nothing is known";
}

}  // namespace
}  // namespace mwt
