#include "harness/tracking/result_set.h"

#include <gtest/gtest.h>

#include "geometry/error.h"
#include "harness/folder_testing.h"
#include "harness/tracking/night.h"
#include "harness/tracking/synthetic_nights_testing.h"

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
  testing::write_synthetic_night(folder.path("r"), runs);
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
  EXPECT_EQ(results.runs[0].yardstick_time_s, std::nullopt);
  EXPECT_EQ(results.runs[1].status, RunStatus::timeout);
  const std::vector<Night> nights = nights_of(results);
  ASSERT_EQ(nights.size(), 1u);
  EXPECT_EQ(nights[0].machine, "unknown");
  EXPECT_EQ(nights[0].values.size(), 3u) << "two cells with failures, one with a time";
}

TEST(ResultSet, ComplaintsNameTheLine) {
  const TestFolder folder;
  EXPECT_NE(complaint(folder.path("none")).find("runs.csv"), std::string::npos);
  write_text(folder.path("runs.csv"), "a,b\n1,2\n");
  EXPECT_NE(complaint(folder.path("")).find("has no column 'algorithm'"), std::string::npos);
  write_text(folder.path("runs.csv"),
             "git_commit,algorithm,params,generator,n,seed,status\nabc,greedy,,uniform,many,7,ok\n");
  EXPECT_NE(complaint(folder.path("")).find("runs.csv:2: 'many' is no n"), std::string::npos);
  write_text(folder.path("runs.csv"), "git_commit,algorithm,params,generator,n,seed,status\nabc,greedy\n");
  EXPECT_NE(complaint(folder.path("")).find("runs.csv:2: malformed row"), std::string::npos);
}

TEST(Nights, OneForEveryCommitAndMachineOrderedByTime) {
  ResultSet results{"", testing::synthetic_runs({}, 5, 1), {testing::synthetic_environment()}};
  for (const RunRecord& run : testing::synthetic_runs({}, 4, 1)) results.runs.push_back(run);
  const std::vector<Night> nights = nights_of(results);
  ASSERT_EQ(nights.size(), 2u);
  EXPECT_EQ(nights[0].git_commit, testing::synthetic_commit(4));
  EXPECT_EQ(nights[1].git_commit, testing::synthetic_commit(5));
  EXPECT_EQ(nights[0].environment, nights[1].environment);
}

}  // namespace
}  // namespace mwt
