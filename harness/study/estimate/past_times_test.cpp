#include "harness/study/estimate/past_times.h"
#include "harness/rating/optimum_search.h"

#include <gtest/gtest.h>

#include "harness/io/testing/folder_testing.h"
#include "harness/records/results_folder.h"

namespace mwt {
namespace {

using testing::TestFolder;

EnvironmentRecord machine(const std::string& cpu) {
  EnvironmentRecord record;
  record.env_id = cpu;
  record.cpu_model = cpu;
  record.logical_cpus = 2;
  return record;
}

RunRecord run_of(Index n, double seconds, const std::string& cpu) {
  RunRecord run;
  run.run_id = std::to_string(n) + cpu;
  run.env_id = cpu;
  run.algorithm = "flip";
  run.params = "order=best";
  run.generator = "uniform";
  run.n = n;
  run.status = RunStatus::ok;
  run.time_limit_s = 10;
  run.wall_time_s = seconds;
  run.weight_lower = run.weight_upper = 1;
  return run;
}

double predicted(const TimeModel& model, const std::string& algorithm, Index n) {
  const TimePrediction prediction = model.predict({algorithm, "uniform", n}, 60);
  return prediction.basis == TimeBasis::recorded ? prediction.seconds : -1;
}

TEST(PastTimes, AreThoseOfAnyStudyOnThisMachine) {
  const TestFolder folder;
  StudyRecords here;
  here.environments = {machine("here")};
  here.runs = {run_of(10, 1, "here"), run_of(20, 9.9, "here"), run_of(30, 0, "here")};
  here.runs[1].stopped_early = true;
  here.runs[2].wall_time_s.reset();
  here.runs[2].status = RunStatus::timeout;
  InstanceRecord instance;
  instance.env_id = "here";
  instance.generator = "uniform";
  instance.n = 10;
  instance.optimality = "proved";
  instance.optimum_source = "exact";
  instance.optimum_time_s = 3;
  here.instances = {instance, instance};
  here.instances[1].n = 20;
  here.instances[1].optimum_note = kCachedNote;
  write_records(folder.path("results/nightly/one"), here);
  StudyRecords elsewhere;
  elsewhere.environments = {machine("elsewhere")};
  elsewhere.runs = {run_of(40, 1, "elsewhere")};
  write_records(folder.path("results/elsewhere"), elsewhere);
  std::filesystem::create_directory(folder.path("results/broken"));
  testing::write_text(folder.path("results/broken/runs.csv"), "no,records\n");
  TimeModel model;
  const PastTimes past = add_past_times(model, {folder.path("results"), folder.path("missing")}, machine("here"), 1);
  EXPECT_EQ(past.runs, 3u);
  EXPECT_EQ(past.folders, 1u);
  EXPECT_EQ(predicted(model, "flip order=best", 10), 1);
  EXPECT_EQ(model.predict({"flip order=best", "uniform", 20}, 60).high, 60) << "it stopped at its limit";
  EXPECT_EQ(model.predict({"flip order=best", "uniform", 30}, 60).low, 10);
  EXPECT_EQ(predicted(model, "exact", 10), 3);
  EXPECT_EQ(predicted(model, "exact", 20), -1) << "a look-up in the cache tells nothing";
  EXPECT_EQ(add_past_times(model, {folder.path("results/nightly/one")}, machine("here"), 2).runs, 0u)
      << "other threads";
}

}  // namespace
}  // namespace mwt
