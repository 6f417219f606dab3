#include "harness/study/merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/records/testing/records_testing.h"
#include "harness/run/testing/algorithms_testing.h"
#include "harness/study/run_study.h"

namespace mwt {
namespace {

using testing::lasting;
using testing::read_text;
using testing::TestFolder;
using testing::write_text;

constexpr const char* kStudy = R"(name = "s"
summary = "t"
families = ["uniform", "fan"]
sizes = [10, 12]
seeds = [1, 2]
algorithms = ["well", "throws", "fan_exact", "small"]
repetitions = 2
min_time_s = 0.0001
[limits]
time_s = 5
[optimum]
sources = ["weak_bound"]
)";

class Merge : public ::testing::Test {
 protected:
  Merge() { write_text(folder_.path("s.toml"), kStudy); }

  void run(const std::string& out, const Shard& shard = {}, const std::string& study_file = "s.toml") {
    std::ostringstream ignored;
    RunOptions options;
    options.folder = folder_.path(out);
    options.shard = shard;
    const StudyOutcome outcome =
        run_study(read_study(folder_.path(study_file)), testing::test_catalogue(), options, ignored);
    EXPECT_FALSE(outcome.interrupted);
  }

  std::size_t merge(const std::vector<std::string>& names) {
    MergeOptions options;
    for (const std::string& name : names) options.folders.push_back(folder_.path(name));
    options.target = folder_.path("merged");
    return merge_results(options, testing::test_catalogue()).runs;
  }

  void expect_refusal(const std::vector<std::string>& names, const std::string& part) {
    try {
      merge(names);
      ADD_FAILURE() << "merged although " << part;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(folder_.path("merged/runs.csv")));
  }

  TestFolder folder_;
};

TEST_F(Merge, FourShardsEqualTheSingleRun) {
  run("whole");
  for (std::size_t number = 1; number <= 4; ++number) run(std::to_string(number), {number, 4});
  EXPECT_EQ(merge({"3", "1", "4", "2"}), 48u);
  const StudyRecords whole = read_records(folder_.path("whole"));
  const StudyRecords merged = read_records(folder_.path("merged"));
  EXPECT_EQ(lasting(run_columns(), merged.runs), lasting(run_columns(), whole.runs));
  EXPECT_EQ(lasting(instance_columns(), merged.instances), lasting(instance_columns(), whole.instances));
  EXPECT_EQ(merged.environments.size(), 4u);
  EXPECT_EQ(merged.environments[1].shard, "1/4");
  EXPECT_EQ(read_text(folder_.path("merged/study.toml")), kStudy);
}

TEST_F(Merge, RefusesOverlapsGapsAndMixtures) {
  run("1", {1, 2});
  run("2", {2, 2});
  expect_refusal({"1"}, "of 48 runs are missing, the first: ");
  expect_refusal({"1", "2", "1"}, "overlap: both have ");
  expect_refusal({"1", "nothing"}, "nothing/study.toml");
  EXPECT_FALSE(std::filesystem::exists(folder_.path("nothing")));
  write_text(folder_.path("other.toml"), std::string(kStudy) + "# another\n");
  run("other", {2, 2}, "other.toml");
  expect_refusal({"1", "other"}, "different studies");
}

TEST_F(Merge, RefusesCommitsThatDifferAndRunsNobodyPlans) {
  run("1", {1, 2});
  run("2", {2, 2});
  StudyRecords records = read_records(folder_.path("2"));
  for (RunRecord& record : records.runs) record.git_commit = "0000000";
  write_records(folder_.path("old"), records);
  expect_refusal({"1", "old"}, "different builds");
  records = read_records(folder_.path("2"));
  records.runs.front().run_id = "unheard of";
  write_records(folder_.path("strange"), records);
  expect_refusal({"1", "strange"}, "does not plan its run");
}

TEST_F(Merge, AClaimThatAnotherShardDisprovesIsAnError) {
  run("1", {1, 2});
  run("2", {2, 2});
  StudyRecords records = read_records(folder_.path("2"));
  RunRecord& claimant = *std::find_if(records.runs.begin(), records.runs.end(),
                                      [](const RunRecord& run) { return run.status == RunStatus::ok; });
  claimant.certified_lower = 2 * *claimant.weight_upper;
  write_records(folder_.path("wrong"), records);
  EXPECT_EQ(merge({"1", "wrong"}), 48u);
  std::size_t disproved = 0;
  for (const RunRecord& record : read_records(folder_.path("merged")).runs) {
    const bool is_claimant = record.run_id == claimant.run_id;
    EXPECT_EQ(record.message.starts_with("CONTRADICTION"), is_claimant);
    disproved += is_claimant ? 1 : 0;
  }
  EXPECT_EQ(disproved, 1u);
}

TEST_F(Merge, RefusesDifferentPointsUnderOneName) {
  run("1", {1, 2});
  run("2", {2, 2});
  StudyRecords records = read_records(folder_.path("2"));
  records.runs.front().instance_id = "another";
  write_records(folder_.path("strange"), records);
  expect_refusal({"1", "strange"}, "different points under one name, ");
}

TEST_F(Merge, NeverOverwrites) {
  run("whole");
  write_text(folder_.path("merged"), "a file");
  expect_refusal({"whole"}, "merged");
  EXPECT_EQ(read_text(folder_.path("merged")), "a file");
}

}  // namespace
}  // namespace mwt
