#include "harness/study/dry_run.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "geometry/error.h"
#include "harness/algorithms_testing.h"
#include "harness/folder_testing.h"
#include "harness/study/estimate.h"

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
                           "between 36.0 ms and 90.0 s", "nothing was run"}) {
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
  const Plan plan = make_plan(study, testing::test_catalogue());
  StudyRecords records;
  RunRecord run;
  run.algorithm = "well";
  run.generator = "uniform";
  run.n = 20;
  run.wall_time_s = 2;
  records.runs = {run};
  const DurationEstimate estimate = estimate_duration(study, testing::test_catalogue(), plan, records);
  EXPECT_NEAR(estimate.likely, 6, 0.1) << "three seeds";
  EXPECT_EQ(estimate.known, 6u) << "these, and three that are not started";
  EXPECT_NEAR(estimate.most, 90, 1e-9);
}

}  // namespace
}  // namespace mwt
