// Shards, their tasks and what they leave behind, without Slurm; testing/cluster_test.py has one.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <sstream>

#include "base/error.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/records/testing/records_testing.h"
#include "harness/run/testing/algorithms_testing.h"
#include "harness/study/cluster/balance.h"
#include "harness/study/cluster/scripts.h"
#include "harness/study/cluster/shard_task.h"
#include "harness/study/cluster/status.h"
#include "harness/study/cluster/submit.h"
#include "harness/study/run_study.h"

namespace mwt {
namespace {

using testing::entry;
using testing::lasting;
using testing::TestFolder;
using testing::write_text;

constexpr const char* kStudy = R"(name = "s"
summary = "t"
families = ["uniform", "fan"]
sizes = [10, 12]
seeds = [1, 2]
algorithms = ["well", "signals"]
repetitions = 2
min_time_s = 0.0001
[limits]
time_s = 5
[optimum]
sources = ["weak_bound"]
)";

// The file that makes `signals` do so, which it removes.
std::string signal_file;
int signal_number = SIGUSR1;

// As Slurm does: the signal reaches every process of the job.
Solution signal_once(Points points, Context& context) {
  if (std::filesystem::remove(signal_file)) {
    kill(getppid(), signal_number);
    std::raise(signal_number);
  }
  return testing::solve_well(points, context);
}

Catalogue catalogue() {
  static const std::vector<AlgorithmInfo> algorithms = {
      entry("well", testing::solve_well),
      entry("signals", signal_once),
      entry("weak_bound", testing::solve_with_weak_bound, Exactness::exact),
  };
  return {algorithms, generators()};
}

class ClusterShards : public ::testing::Test {
 protected:
  ClusterShards() {
    write_text(folder_.path("s.toml"), kStudy);
    signal_file = folder_.path("signal");
    signal_number = SIGUSR1;
  }

  [[nodiscard]] Study study() const { return read_study(folder_.path("s.toml")); }

  ClusterFolder written(std::size_t shards) {
    SubmitOptions options;
    options.study_path = folder_.path("s.toml");
    options.folder = folder_.path("cluster");
    options.shards = shards;
    options.only_writes = true;
    submit_study(study(), catalogue(), options, out_);
    return ClusterFolder(options.folder);
  }

  TaskEnd task(const ClusterFolder& folder, std::size_t shard, bool only_optima = false) {
    return run_shard_task(folder, catalogue(), shard, only_optima, out_);
  }

  // The task that gets a signal in its first run of `signals`.
  TaskEnd signalled_task(const ClusterFolder& folder, std::size_t shard) {
    write_text(signal_file, "");
    return task(folder, shard);
  }

  [[nodiscard]] StudyRecords records_of_single_run() {
    RunOptions options;
    options.folder = folder_.path("whole");
    static_cast<void>(run_study(study(), catalogue(), options, out_));
    return read_records(options.folder);
  }

  [[nodiscard]] static StudyRecords records_of(const ClusterFolder& folder, std::size_t shard) {
    return read_records(folder.last_attempt(shard).value());
  }

  void expect_merged_like_single_run(const ClusterFolder& folder) {
    const StudyRecords whole = records_of_single_run();
    EXPECT_EQ(merge_shards(folder, catalogue()).runs, whole.runs.size());
    const StudyRecords merged = read_records(folder.file("merged"));
    EXPECT_EQ(lasting(run_columns(), merged.runs), lasting(run_columns(), whole.runs));
    EXPECT_EQ(lasting(instance_columns(), merged.instances), lasting(instance_columns(), whole.instances));
  }

  TestFolder folder_;
  std::ostringstream out_;
};

TEST_F(ClusterShards, AreBalancedByTime) {
  const Plan plan = make_plan(study(), catalogue());
  ASSERT_EQ(plan.instances.size(), 6u);  // a fan has no seed
  const std::vector<InstanceTime> times = {{1, 0}, {0, 1}, {0, 1}, {0, 1}, {0.5, 0.5}, {0, 5}};
  const std::vector<ShardRow> rows = balanced_shards(plan, times, 2);
  EXPECT_EQ(times_of_shards(rows, 2), (std::vector<double>{5, 5}));
  EXPECT_EQ(rows[0].runs, 4u);
  EXPECT_NE(rows[5].shard, rows[0].shard);
  EXPECT_THROW(static_cast<void>(balanced_shards(plan, times, 7)), InputError);
}

TEST_F(ClusterShards, ScriptsHaveTheOptionsInTheirOrder) {
  SlurmRequest request;
  request.memory = "4G";
  request.others = {"--nice=100"};
  const std::string text = script_text(JobKind::runs, "/a b/c", study(), request);
  EXPECT_TRUE(text.starts_with("#!/bin/bash\n")) << text;
  EXPECT_NE(text.find("#SBATCH --output=\"/a b/c/logs/runs-%a.log\"\n"), std::string::npos) << text;
  EXPECT_NE(text.find("--mem=2560M\n#SBATCH --mem=4G\n#SBATCH --nice=100\n"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("exec \"/a b/c/mwt\" cluster task \"/a b/c\" \"$SLURM_ARRAY_TASK_ID\"\n")) << text;
  for (const char* folder : {"/a$b", "/a\"b", "/100%", "/a\nb", "/a`b"}) {
    EXPECT_THROW(static_cast<void>(script_text(JobKind::runs, folder, study(), {})), InputError) << folder;
  }
}

TEST_F(ClusterShards, OptimaThenRunsThenMergedEqualTheSingleRun) {
  const ClusterFolder folder = written(3);
  EXPECT_EQ(task(folder, 1, true), TaskEnd::complete);
  EXPECT_EQ(records_of(folder, 1).instances.size(), folder.labels_of(1).size());
  EXPECT_TRUE(records_of(folder, 1).runs.empty());
  for (std::size_t shard = 1; shard <= 3; ++shard) EXPECT_EQ(task(folder, shard), TaskEnd::complete);
  EXPECT_EQ(records_of(folder, 1).environments.size(), 2u);
  EXPECT_TRUE(status_of(folder).has_all_runs());
  expect_merged_like_single_run(folder);
  EXPECT_THROW(static_cast<void>(merge_shards(folder, catalogue())), InputError) << "merged already";
}

TEST_F(ClusterShards, ATaskStopsBeforeItsLimitAndTheNextGoesOn) {
  const ClusterFolder folder = written(1);
  EXPECT_EQ(signalled_task(folder, 1), TaskEnd::stopped) << "there is no Slurm to queue it again";
  EXPECT_EQ(end_of_attempt(*folder.last_attempt(1)), "stopped before its time limit");
  const std::vector<RunRecord> first = records_of(folder, 1).runs;
  EXPECT_TRUE(std::ranges::all_of(first, [](const RunRecord& run) { return run.status == RunStatus::ok; }))
      << "what the signal ended is no row";
  signal_number = SIGTERM;
  EXPECT_EQ(signalled_task(folder, 1), TaskEnd::stopped);
  EXPECT_EQ(end_of_attempt(*folder.last_attempt(1)), "stopped by a signal");
  EXPECT_EQ(task(folder, 1), TaskEnd::complete);
  EXPECT_TRUE(folder.last_attempt(1)->ends_with("attempt-3"));
  const std::vector<RunRecord> all = records_of(folder, 1).runs;
  ASSERT_EQ(all.size(), 24u);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(all[i].recorded_at, first[i].recorded_at) << "was run twice";
  expect_merged_like_single_run(folder);
}

TEST_F(ClusterShards, ATaskWithoutProgressIsGivenUpTheSecondTime) {
  write_text(folder_.path("s.toml"),
             "name = 's'\nsummary = 't'\nfamilies = ['fan']\nsizes = [10]\nalgorithms = ['signals']\n"
             "optimum.seek = false\n");
  const ClusterFolder folder = written(1);
  EXPECT_EQ(task(folder, 1, true), TaskEnd::complete);  // the instance's row
  EXPECT_EQ(signalled_task(folder, 1), TaskEnd::stopped);
  EXPECT_EQ(signalled_task(folder, 1), TaskEnd::stuck);
  EXPECT_NE(end_of_attempt(*folder.last_attempt(1))->find("give it more --time"), std::string::npos);
}

// On a network file system a process may live that Slurm has lost sight of.
TEST_F(ClusterShards, WhatALostProcessWritesChangesNothing) {
  const ClusterFolder folder = written(1);
  EXPECT_EQ(signalled_task(folder, 1), TaskEnd::stopped);
  const std::string lost = *folder.last_attempt(1);
  EXPECT_EQ(task(folder, 1), TaskEnd::complete);
  const RunRecord last = records_of(folder, 1).runs.back();
  ResultsFolder(lost, "s", kStudy, true, FolderUse::owned).append(last);
  EXPECT_EQ(records_of(folder, 1).runs.size(), 24u);
  expect_merged_like_single_run(folder);
}

// A task that was killed while it copied what the last one had recorded.
TEST_F(ClusterShards, AHalfBegunAttemptCountsForNothing) {
  const ClusterFolder folder = written(1);
  EXPECT_EQ(signalled_task(folder, 1), TaskEnd::stopped);
  std::filesystem::create_directory(folder.file("shards/1/attempt-2"));
  write_text(folder.file("shards/1/attempt-2/runs.csv"), "");
  EXPECT_TRUE(folder.last_attempt(1)->ends_with("attempt-1"));
  EXPECT_EQ(task(folder, 1), TaskEnd::complete);
  EXPECT_TRUE(folder.last_attempt(1)->ends_with("attempt-3"));
  expect_merged_like_single_run(folder);
}

TEST_F(ClusterShards, GapsAndChangesAreRefused) {
  const ClusterFolder folder = written(2);
  const auto message_of = [](const auto& action) { return test::message_of<InputError>(action); };
  const auto merge = [&] { static_cast<void>(merge_shards(folder, catalogue())); };
  EXPECT_EQ(task(folder, 1), TaskEnd::complete);
  EXPECT_NE(message_of(merge).find("shard 2 has not begun"), std::string::npos);
  EXPECT_EQ(task(folder, 2, true), TaskEnd::complete);
  EXPECT_NE(message_of(merge).find("runs are missing"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.file("merged")));
  EXPECT_THROW(static_cast<void>(task(folder, 3)), InputError);
  write_text(folder_.path("s.toml"), std::string(kStudy) + "# another\n");
  EXPECT_NE(message_of([&] { static_cast<void>(task(folder, 2)); }).find("has changed since"), std::string::npos);
  EXPECT_NE(message_of([&] { written(2); }).find("something in it already"), std::string::npos);
  EXPECT_NE(message_of([&] { ClusterFolder(folder_.path("none")); }).find("no cluster.csv"), std::string::npos);
}

TEST_F(ClusterShards, TheStatusFitsATerminal) {
  const ClusterFolder folder = written(2);
  EXPECT_EQ(task(folder, 1), TaskEnd::complete);
  EXPECT_EQ(signalled_task(folder, 2), TaskEnd::stopped);
  const std::string text = status_text(folder, status_of(folder), 80);
  EXPECT_NE(text.find("\n1      done "), std::string::npos) << text;
  EXPECT_NE(text.find("\n2      begun "), std::string::npos) << text;
}

}  // namespace
}  // namespace mwt
