// Runs `mwt compare`, `mwt track` and `mwt history` as their users do.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/cli/testing/commands_testing.h"
#include "harness/io/text/csv.h"
#include "harness/tracking/testing/synthetic_nightly_runs.h"

namespace mwt {
namespace {

using testing::CommandResult;

class TrackingCommands : public testing::CommandTest {
 protected:
  void write_nightly_run(int nightly_run, const testing::Tamper& tamper = {}) const {
    testing::write_synthetic_nightly_run(path("n" + std::to_string(nightly_run)),
                                         testing::synthetic_runs({}, nightly_run, 1, tamper));
  }
};

void heavier_flip(int nightly_run, RunRecord& run, RandomEngine&) {
  if (nightly_run == 1 && run.algorithm == "flip") *run.weight_lower += 1, *run.weight_upper += 1;
}

TEST_F(TrackingCommands, CompareExitsWithOneOnARegression) {
  write_nightly_run(0);
  write_nightly_run(1, heavier_flip);
  const CommandResult worse = mwt("compare n0 n1");
  EXPECT_EQ(worse.exit_code, 1) << worse.errors;
  EXPECT_TRUE(worse.output.starts_with("8 regressions (flip on clustered n=100 seed=1: ")) << worse.output;
  const CommandResult better = mwt("compare n1 n0");
  EXPECT_EQ(better.exit_code, 0);
  EXPECT_TRUE(better.output.starts_with("0 regressions, 8 improvements")) << better.output;
  const auto json = nlohmann::json::parse(mwt("compare n0 n1 --json").output);
  EXPECT_EQ(json["findings"].size(), 8u);
  EXPECT_EQ(json["regression"], true);
  EXPECT_NE(mwt("compare n0 n1 --markdown").output.find("| flip | clustered n=100 seed=1 |"), std::string::npos);
}

TEST_F(TrackingCommands, MistakesOfCompare) {
  write_nightly_run(0);
  expect_mistake("compare", "compare takes two folders");
  expect_mistake("compare n0", "compare takes two folders");
  expect_mistake("compare n0 missing", "missing/runs.csv");
  expect_mistake("compare n0 n0 --json --markdown", "not both");
  expect_mistake("compare n0 n0 --measure weight", "not a time");
  expect_mistake("compare n0 n0 --threshold nan", "'nan' is not a number");
  expect_mistake("compare --build-a .", "belong together");
  expect_mistake("compare --build-a . --build-b .", "--study");
  expect_mistake("compare --build-a . --build-b . --study claims", "mwt: no program is there");
}

TEST_F(TrackingCommands, TwoAlgorithmsOfOneFolder) {
  write_nightly_run(0);
  const CommandResult result = mwt("compare n0 --algorithm-a greedy --algorithm-b patch --verdict v.json");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.output.starts_with("A = greedy, B = patch, in n0\nalpha: patch better")) << result.output;
  EXPECT_EQ(nlohmann::json::parse(read("v.json"))["alpha"].size(), 5u);
  expect_mistake("compare n0 --algorithm-a greedy", "belong together");
  expect_mistake("compare n0 n0 --algorithm-a greedy --algorithm-b patch", "one folder");
  expect_mistake("compare n0 --algorithm-a greedy --algorithm-b patch --threshold 3", "--measure, --json");
  expect_mistake("compare n0 --algorithm-a greedy --algorithm-b none", "it has: delaunay, exact");
}

TEST_F(TrackingCommands, TwoBuildsAreRunInTurn) {
  write(
      "s.toml",
      "name = \"s\"\nsummary = \"x\"\nfamilies = [{ name = \"clustered\", parameters = { clusters = 3 } }]\n"
      "sizes = [20]\nalgorithms = [\"delaunay\", { name = \"flip\", parameters = { start = \"sweep\" } }, \"sweep\"]\n"
      "min_time_s = 0.0001\n");
  const std::string builds = std::string("compare --build-a " MWT_EXECUTABLE " --build-b ") + MWT_EXECUTABLE;
  const CommandResult result =
      mwt(builds + " --study s.toml --out ab --repetitions 3 --algorithm flip --algorithm sweep --json");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["paired"], true);
  ASSERT_EQ(json["cells"].size(), 2u);
  EXPECT_EQ(json["cells"][0]["verdict"], "identical binary");
  EXPECT_EQ(json["cells"][0]["algorithm"], "flip order=stack start=sweep trace=off");
  const auto forced = nlohmann::json::parse(mwt("compare ab/base ab/new --paired --force --json").output);
  EXPECT_EQ(forced["cells"][0]["observations"], 3);
  expect_mistake(builds + " --study s.toml --out ab", "already; continue");
  expect_mistake(builds + " --study s.toml --out other --algorithm greedy", "has no algorithm 'greedy'");
}

// They used to be left out, and could never be settled.
TEST_F(TrackingCommands, PointFilesAndStartsAreRunInTurnToo) {
  write("p[1].txt", "0 0\n4 0\n4.5 3\n0 3\n");
  write("start.csv", "0,1,2\n0,2,3\n");
  write("s.toml",
        "name = \"s\"\nsummary = \"x\"\nalgorithms = [\"delaunay\", { name = \"flip_naive\", parameters = { start = "
        "\"start.csv\" } }]\nmin_time_s = 0.0001\n[instances]\nfolder = \".\"\nfiles = [\"*.txt\"]\n");
  const CommandResult result = mwt("compare --build-a " MWT_EXECUTABLE " --build-b " MWT_EXECUTABLE
                                   " --study s.toml --out ab --repetitions 1 --json");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  ASSERT_EQ(json["cells"].size(), 2u) << result.output;
  EXPECT_EQ(json["cells"][0]["instance"], "file file=p[1].txt n=4 seed=1");
  EXPECT_NE(json["cells"][1]["algorithm"].get<std::string>().find(" start=start.csv"), std::string::npos);
}

// What the folders leave open is run again by both builds, which are one program here: --force lets it be judged. One
// repetition a look cannot settle anything, so that there are three looks.
TEST_F(TrackingCommands, WhatFoldersLeaveOpenIsRunInTurn) {
  write("s.toml",
        "name = \"s\"\nsummary = \"x\"\nfamilies = [\"uniform\"]\nsizes = [20]\n"
        "algorithms = [\"delaunay\", \"sweep\"]\nrepetitions = 3\nmin_time_s = 0.0001\n[optimum]\nseek = false\n");
  for (const char* folder : {"a", "b"}) EXPECT_EQ(mwt(std::string("run s.toml --out ") + folder).exit_code, 0);
  StudyRecords slow = read_records(path("b"));
  for (RunRecord& run : slow.runs) {
    if (run.algorithm == "sweep") *run.wall_time_s *= 100, *run.cpu_time_s *= 100;
  }
  write_records(path("c"), slow);
  const std::string builds = " --force --build-a " MWT_EXECUTABLE " --build-b " MWT_EXECUTABLE " --study s.toml";
  const CommandResult result = mwt("compare a c --json --out ab --repetitions 1 --verdict verdict.json" + builds);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, read("verdict.json"));
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["outcome"], "unclear");
  EXPECT_EQ(json["suspected"]["outcome"], "unclear");
  EXPECT_EQ(json["confirmed"]["compared_cells"], 2);
  EXPECT_EQ(json["confirmed"]["cells"][0]["observations"], 3);
  // Not a hundred times slower, however busy the machine is.
  const auto ratio = json["confirmed"]["cells"][1]["ratio"].get<double>();
  EXPECT_LT(ratio, 20);
  EXPECT_GT(ratio, 0.05);
}

TEST_F(TrackingCommands, TheTimeForRunsInTurnIsLimited) {
  write("s.toml",
        "name = \"s\"\nsummary = \"x\"\nfamilies = [\"uniform\"]\nsizes = [20]\nalgorithms = [\"delaunay\"]\n"
        "repetitions = 3\nmin_time_s = 0.0001\n[optimum]\nseek = false\n");
  for (const char* folder : {"a", "b"}) EXPECT_EQ(mwt(std::string("run s.toml --out ") + folder).exit_code, 0);
  const CommandResult result =
      mwt("compare a b --out ab --repetitions 1000 --budget 0.01 --force --build-a " MWT_EXECUTABLE
          " --build-b " MWT_EXECUTABLE " --study s.toml");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.output.starts_with("unclear: ")) << result.output;
  EXPECT_NE(result.output.find("the time for runs in turn was up"), std::string::npos) << result.output;
}

TEST_F(TrackingCommands, WhatTheStudyDoesNotHaveKeepsItsVerdict) {
  write_nightly_run(0);
  write_nightly_run(1, [](int, RunRecord& run, RandomEngine&) {
    if (run.algorithm == "flip") *run.wall_time_s *= 3;
  });
  EXPECT_EQ(mwt("compare n0 n1").exit_code, 1);
  write("s.toml",
        "name = \"s\"\nsummary = \"x\"\nfamilies = [\"uniform\"]\nsizes = [20]\nalgorithms = [\"delaunay\"]\n");
  const std::string builds =
      " --build-a " MWT_EXECUTABLE " --build-b " MWT_EXECUTABLE " --study s.toml --repetitions 1";
  const CommandResult result = mwt("compare n0 n1 --json --out ab" + builds);
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["outcome"], "regression");
  EXPECT_GE(json["not_run"].size(), 8u);
  EXPECT_EQ(mwt("compare n0 n0 --out other" + builds).exit_code, 0);
  EXPECT_FALSE(exists("other")) << "nothing to confirm";
}

TEST_F(TrackingCommands, ABuildThatFailsIsNamed) {
  write("s.toml",
        "name = \"s\"\nsummary = \"x\"\nfamilies = [\"uniform\"]\nsizes = [20]\nalgorithms = [\"delaunay\"]\n");
  expect_mistake("compare --build-a /bin/false --build-b /bin/false --study s.toml --out ab",
                 "/bin/false: exit code 1");
}

TEST_F(TrackingCommands, TrackIsIdempotentAndExportsEverything) {
  write_nightly_run(0);
  write_nightly_run(1);
  EXPECT_NE(mwt("track n1 n0").output.find("values added"), std::string::npos);
  const CommandResult again = mwt("track n1");
  EXPECT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_NE(again.output.find("values already in the history"), std::string::npos) << again.output;
  EXPECT_TRUE(exists("results/history.sqlite"));

  EXPECT_EQ(mwt("history changes").output, "no lasting change; nightly runs in the history: 2\n");
  const CommandResult exported = mwt("history export --csv");
  const std::vector<CsvRow> rows = parse_csv(exported.output);
  const std::size_t cells = 6 * 2 * 2 * 2, measures = 7;
  ASSERT_EQ(rows.size(), 1 + 2 * cells * measures);
  EXPECT_EQ(rows[1][2], testing::synthetic_commit(0));
  EXPECT_EQ(rows.back()[2], testing::synthetic_commit(1));
  EXPECT_EQ(mwt("history export --csv -o all.csv").output, "");
  EXPECT_EQ(read("all.csv"), exported.output);
}

TEST_F(TrackingCommands, HistoryTellsWhatChanged) {
  for (int nightly_run = 0; nightly_run < 6; ++nightly_run) {
    write_nightly_run(nightly_run, [](int this_nightly_run, RunRecord& run, RandomEngine&) {
      if (this_nightly_run >= 3 && run.algorithm == "flip") *run.alpha_lower += 0.25, *run.alpha_upper += 0.25;
    });
  }
  EXPECT_EQ(mwt("track n0 n1 n2 n3 n4 n5 --history h.sqlite").exit_code, 0);
  const auto changes = nlohmann::json::parse(mwt("history changes --history h.sqlite --json").output);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0]["algorithm"], "flip");
  EXPECT_EQ(changes[0]["aspect"], "quality");
  EXPECT_EQ(changes[0]["commit"], testing::synthetic_commit(3));
  EXPECT_EQ(changes[0]["steps"].size(), 4u);
  const auto all = nlohmann::json::parse(mwt("history series --history h.sqlite --json").output);
  EXPECT_EQ(all["nightly_runs"].size(), 6u);
  EXPECT_EQ(all["series"].size(), 6u * 4 * 7) << "algorithms, instances without their seeds, measures";
  EXPECT_EQ(all["series"][0]["values"].size(), 6u);
  EXPECT_EQ(all["changes"], changes);
  EXPECT_TRUE(mwt("history changes --history h.sqlite").output.starts_with("2026-01-04 regression flip: quality +"));
}

TEST_F(TrackingCommands, MistakesOfTrackAndHistory) {
  expect_mistake("track", "dir is required");
  expect_mistake("track missing", "missing/runs.csv");
  expect_mistake("history changes", "results/history.sqlite: there is no history here; mwt track FOLDER");
  expect_mistake("history forget", "known: export, changes, series");
  expect_mistake("history export", "--csv");
  EXPECT_FALSE(exists("results"));
}

}  // namespace
}  // namespace mwt
