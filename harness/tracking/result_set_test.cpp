#include "harness/tracking/result_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/io/text/csv.h"
#include "harness/tracking/history/nightly_run.h"
#include "harness/tracking/testing/synthetic_nightly_runs.h"

namespace mwt {
namespace {

using testing::TestFolder;
using testing::write_text;

std::string complaint(const std::string& folder) {
  try {
    (void)read_results(folder);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ResultSet, ReadsWhatAStudyWrote) {
  const TestFolder folder;
  const auto runs = testing::synthetic_runs({}, 3, 1);
  testing::write_synthetic_nightly_run(folder.path("r"), runs);
  const ResultSet results = read_results(folder.path("r"));
  ASSERT_EQ(results.runs.size(), runs.size());
  EXPECT_EQ(results.runs[7].wall_time_s, runs[7].wall_time_s);
  EXPECT_EQ(machine_of(results.environment_of(results.runs[0])), "Abacus 2000, 2 CPUs, 8 GiB");
}

// The first columns of version 1, in another order, and an unknown one.
TEST(ResultSet, ReadsOtherVersionsByTheNamesOfColumns) {
  const TestFolder folder;
  write_text(folder.path("runs.csv"),
             "schema_version,git_commit,surprise,algorithm,params,generator,n,seed,status,wall_time_s\n"
             "1,abc,x,greedy,,uniform,100,7,ok,0.25\n"
             "1,abc,x,greedy,,uniform,200,7,timeout,\n"
             "1,abc,x,gre");
  const ResultSet results = read_results(folder.path(""));
  ASSERT_EQ(results.runs.size(), 2u);
  EXPECT_EQ(results.runs[0].wall_time_s, 0.25);
  EXPECT_EQ(results.runs[0].delaunay_time_s, std::nullopt);
  EXPECT_EQ(results.runs[1].status, RunStatus::timeout);
  const std::vector<NightlyRun> nightly_runs = nightly_runs_of(results);
  ASSERT_EQ(nightly_runs.size(), 1u);
  EXPECT_EQ(nightly_runs[0].machine, "unknown");
  EXPECT_EQ(nightly_runs[0].values.size(), 3u) << "two cells with failures, one with a time";
}

TEST(ResultSet, OldNamesBecomeThePresentOnes) {
  const TestFolder folder;
  write_text(folder.path("runs.csv"),
             "schema_version,algorithm,params,generator,n,seed,status,git_commit,yardstick_time_s\n"
             "2,greedy_report,,uniform,10,1,ok,a,0.25\n"
             "2,flip_report,,uniform,10,1,ok,a,0.5\n");
  const ResultSet results = read_results(folder.path(""));
  ASSERT_EQ(results.runs.size(), 2u);
  EXPECT_EQ(results.runs[0].algorithm, "greedy_naive");
  EXPECT_EQ(results.runs[1].algorithm, "flip_naive");
  EXPECT_EQ(results.runs[0].delaunay_time_s, 0.25);
}

TEST(ResultSet, ComplaintsNameTheLine) {
  const TestFolder folder;
  EXPECT_NE(complaint(folder.path("none")).find("runs.csv"), std::string::npos);
  write_text(folder.path("runs.csv"), "a,b\n1,2\n");
  EXPECT_NE(complaint(folder.path("")).find("has no column 'algorithm'"), std::string::npos);
  const std::string header = "schema_version,git_commit,algorithm,params,generator,n,seed,status\n";
  write_text(folder.path("runs.csv"), header + "1,abc,greedy,,uniform,many,7,ok\n");
  EXPECT_NE(complaint(folder.path("")).find("runs.csv:2: 'many' is no n"), std::string::npos);
  write_text(folder.path("runs.csv"), header + "1,abc,greedy\n");
  EXPECT_NE(complaint(folder.path("")).find("runs.csv:2: malformed row"), std::string::npos);
}

const std::string kVersion = std::to_string(kSchemaVersion);

class DamagedResults : public ::testing::Test {
 protected:
  DamagedResults() { testing::write_synthetic_nightly_run(folder_.path("r"), testing::synthetic_runs({}, 3, 1)); }

  /// Replaces text in runs.csv, everywhere, and says what the reader complains about.
  std::string complaint_after(const std::string& text, const std::string& replacement) {
    std::string content = testing::read_text(folder_.path("r/runs.csv"));
    for (std::size_t at = content.find(text); at != std::string::npos; at = content.find(text, at + replacement.size()))
      content.replace(at, text.size(), replacement);
    write_text(folder_.path("r/runs.csv"), content);
    return complaint(folder_.path("r"));
  }

  TestFolder folder_;
};

// With its times renamed a folder had no times, and so no regressions.
TEST_F(DamagedResults, RenamedColumnsAreRefused) {
  EXPECT_NE(complaint_after("wall_time_s", "wall")
                .find("column 22 is 'wall' where schema version " + kVersion + " has 'wall_time_s'"),
            std::string::npos);
}

TEST_F(DamagedResults, MissingColumnsAreRefused) {
  std::string content;
  for (CsvRow row : parse_csv(testing::read_text(folder_.path("r/runs.csv")))) {
    row.resize(kFirstRunColumns - 1);
    content += csv_line(row);
  }
  write_text(folder_.path("r/runs.csv"), content);
  const std::string expected = "column " + std::to_string(kFirstRunColumns) + " is nothing where schema version " +
                               kVersion + " has '" + run_columns()[kFirstRunColumns - 1].name + "'";
  const std::string found = complaint(folder_.path("r"));
  EXPECT_NE(found.find(expected), std::string::npos) << found;
}

TEST_F(DamagedResults, NewerSchemaVersionsAreRefused) {
  const std::string newer = std::to_string(kSchemaVersion + 1);
  EXPECT_NE(complaint_after("\n" + kVersion + ",", "\n" + newer + ",")
                .find("runs.csv:2: schema version " + newer + " is unknown here"),
            std::string::npos);
}

TEST(ResultSet, SeveralSchemaVersionsAreRefused) {
  const TestFolder folder;
  write_text(folder.path("runs.csv"),
             "schema_version,git_commit,algorithm,params,generator,n,seed,status\n1,abc,greedy,,uniform,9,7,ok\n"
             "2,abc,greedy,,uniform,9,7,ok\n");
  EXPECT_NE(complaint(folder.path("")).find("runs.csv:3: schema version 2 after rows of version 1"), std::string::npos);
}

TEST(ResultSet, WhatIsNotANumberIsRefused) {
  std::vector<RunRecord> runs = testing::synthetic_runs({}, 3, 1);
  for (const double damaged : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    runs[4].wall_time_s = damaged;
    const TestFolder folder;
    testing::write_synthetic_nightly_run(folder.path("r"), runs);
    EXPECT_NE(complaint(folder.path("r")).find("runs.csv:6: '"), std::string::npos) << complaint(folder.path("r"));
    EXPECT_THROW((void)read_records(folder.path("r")), InputError) << "mwt report likewise";
  }
}

TEST(ResultSet, CpuTimesOfAClockThatTickedAreLeftOut) {
  const TestFolder folder;
  std::vector<RunRecord> runs = testing::synthetic_runs({}, 3, 1);
  runs[0].cpu_time_s = 0;
  runs[1].wall_time_s = runs[1].cpu_time_s = 0.6;
  runs[1].iterations = 1;
  testing::write_synthetic_nightly_run(folder.path("r"), runs);
  const ResultSet results = read_results(folder.path("r"));
  EXPECT_FALSE(results.runs[0].cpu_time_s);
  EXPECT_TRUE(results.runs[1].cpu_time_s) << "more than a hundred ticks";
  EXPECT_FALSE(results.runs[2].cpu_time_s);
}

TEST(Nights, AChangedStudyOfTheSameNameIsAnotherNight) {
  ResultSet results{"", testing::synthetic_runs({}, 5, 1), {testing::synthetic_environment()}};
  results.study_file = "name = \"synthetic\"\nsizes = [100]\n";
  const std::string before = nightly_runs_of(results).at(0).configuration;
  EXPECT_EQ(nightly_runs_of(results).at(0).configuration, before);
  results.study_file = "name = \"synthetic\"\nsizes = [200]\n";
  EXPECT_NE(nightly_runs_of(results).at(0).configuration, before);
}

TEST(Nights, ACommitThatDoesNotTellTheProgramIsNotTheSameNight) {
  ResultSet results{"", testing::synthetic_runs({}, 5, 1), {testing::synthetic_environment()}};
  const auto configuration_with = [&](const std::string& commit, const std::string& binary) {
    for (RunRecord& run : results.runs) run.git_commit = commit, run.binary_sha256 = binary;
    return nightly_runs_of(results).at(0).configuration;
  };
  EXPECT_EQ(configuration_with("abc", "x"), configuration_with("abc", "y"));
  EXPECT_NE(configuration_with("abc-dirty", "x"), configuration_with("abc-dirty", "y"));
}

TEST(Nights, OneForEveryCommitAndMachineOrderedByTime) {
  ResultSet results{"", testing::synthetic_runs({}, 5, 1), {testing::synthetic_environment()}};
  for (const RunRecord& run : testing::synthetic_runs({}, 4, 1)) results.runs.push_back(run);
  const std::vector<NightlyRun> nightly_runs = nightly_runs_of(results);
  ASSERT_EQ(nightly_runs.size(), 2u);
  EXPECT_EQ(nightly_runs[0].git_commit, testing::synthetic_commit(4));
  EXPECT_EQ(nightly_runs[1].git_commit, testing::synthetic_commit(5));
  EXPECT_EQ(nightly_runs[0].environment, nightly_runs[1].environment);
}

}  // namespace
}  // namespace mwt
