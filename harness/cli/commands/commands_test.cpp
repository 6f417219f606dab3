// Runs the program as its users do.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "algorithms/registry.h"
#include "generators/registry.h"
#include "harness/cli/testing/commands_testing.h"
#include "harness/io/text/text.h"
#include "harness/run/machine/build_info.h"

namespace mwt {
namespace {

using testing::CommandResult;

class Commands : public testing::CommandTest {};

TEST_F(Commands, MistakesOnTheCommandLine) {
  expect_mistake("", "no command");
  expect_mistake("sovle x",
                 "unknown command 'sovle'; known: list, generate, solve, check, draw, convert, run, merge, cluster, "
                 "report, archive, "
                 "compare, track, history, hunt, explore, completion, manual");
  expect_mistake("generate", "family is required");
  expect_mistake("generate uniform --n ten -o p.txt", "--n");
  expect_mistake("generate uniform --n -5 -o p.txt", "--n");
  expect_mistake("generate uniform --n 5 --bogus -o p.txt", "--bogus");
  expect_mistake("generate uniform -o p.txt", "give --n");
  expect_mistake("generate nothing --n 5 -o p.txt", "unknown generator 'nothing'; known: uniform");
  expect_mistake("generate uniform --n 5 --param k=1 -o p.txt", "unknown parameter 'k'");
  expect_mistake("generate uniform --n 5 --param k -o p.txt", "not of the form name=value");
  expect_mistake("generate clustered --n 5 --param sigma=x -o p.txt", "sigma=x is not a number");
  expect_mistake("generate report_example --n 11 -o p.txt", "10");
  expect_mistake("list cats", "known: algorithms, generators, studies");
  EXPECT_FALSE(exists("p.txt"));
}

TEST_F(Commands, NumbersAreDecimal) {
  write("p.txt", "0 0\n1 0\n0 1\n");
  const std::string hundred = mwt("generate uniform --n 100 --seed 8 -o -").output;
  EXPECT_EQ(mwt("generate uniform --n 0100 --seed 08 -o -").output, hundred);
  EXPECT_EQ(std::count(hundred.begin(), hundred.end(), '\n'), 100);
  EXPECT_NE(mwt("generate uniform --n 100 --seed 18446744073709551615 -o -").output, hundred);
  EXPECT_EQ(mwt("solve p.txt --algorithm patch --param k=08 --json").exit_code, 0);
}

TEST_F(Commands, NumbersOutOfRangeAreMistakes) {
  write("p.txt", "0 0\n1 0\n0 1\n");
  const std::vector<std::string> whole = {"generate uniform -o o.txt --n",
                                          "generate uniform -o o.txt --n 5 --seed",
                                          "solve p.txt --algorithm delaunay --threads",
                                          "hunt --algorithm greedy --n 8 --evaluations",
                                          "draw p.txt t.csv -o o.svg --width",
                                          "run report --jobs",
                                          "compare --repetitions"};
  const std::vector<std::string> real = {"solve p.txt --algorithm delaunay --time-limit",
                                         "hunt --algorithm greedy --n 8 --budget", "compare --threshold",
                                         "history changes --min-change"};
  const auto refused = [&](const std::string& command, const std::string& value) {
    const std::string option = command.substr(command.rfind(' ') + 1);
    expect_mistake(command + " '" + value + "'", option + " '" + value + "' is ");
  };
  for (const std::string& command : whole) {
    for (const char* value : {"", "x", "-1", "1.5", "1e3", "0x10", "nan", "99999999999999999999", "1 "})
      refused(command, value);
  }
  for (const std::string& command : real) {
    for (const char* value : {"", "x", "-1", "0", "nan", "-nan", "inf", "1e999", "0x10", "1,5", "5s"})
      refused(command, value);
  }
  EXPECT_FALSE(exists("o.txt"));
}

TEST_F(Commands, NumbersOfParametersAreHeldToTheirKind) {
  for (const char* value : {"", "x", "1.5", "nan", "inf", "99999999999999999999", "-99999999999999999999"})
    expect_mistake("generate clustered --n 9 -o o.txt --param clusters=" + std::string(value),
                   "clusters=" + std::string(value) + " is ");
  for (const char* value : {"", "x", "nan", "inf", "-inf", "1e999"})
    expect_mistake("generate clustered --n 9 -o o.txt --param sigma=" + std::string(value),
                   "sigma=" + std::string(value) + " is ");
}

TEST_F(Commands, UnusablePointFiles) {
  write("words.txt", "0 0\n1 one\n");
  write("nan.txt", "0 0\n1 nan\n0 1\n");
  write("inf.txt", "0 0\n1 inf\n0 1\n");
  write("two.txt", "0 0\n1 1\n");
  write("line.txt", "0 0\n1 1\n2 2\n3 3\n");
  write("equal.txt", "1 1\n1 1\n1 1\n");
  write("empty.txt", "");
  const std::string with = " --algorithm delaunay";
  expect_mistake("solve missing.txt" + with, "missing.txt");
  expect_mistake("solve words.txt" + with, "words.txt:2");
  expect_mistake("solve nan.txt" + with, "nan.txt:2");
  expect_mistake("solve inf.txt" + with, "inf.txt:2");
  expect_mistake("solve two.txt" + with, "at least 3");
  expect_mistake("solve line.txt" + with, "one line");
  expect_mistake("solve equal.txt" + with, "1 distinct point");
  expect_mistake("solve empty.txt" + with, "empty.txt");
  expect_mistake("check missing.txt words.txt", "missing.txt");
  expect_mistake("check two.txt words.txt", "at least 3");
}

TEST_F(Commands, UnknownNamesAndParametersOfAlgorithms) {
  write("points.txt", "0 0\n1 0\n0 1\n");
  expect_mistake("solve points.txt --algorithm nothing", "unknown algorithm 'nothing'");
  expect_mistake("solve points.txt", "--algorithm is required");
  expect_mistake("solve points.txt --algorithm delaunay --param no_such=1", "unknown parameter 'no_such'");
  expect_mistake("solve points.txt --algorithm delaunay --time-limit -1", "--time-limit");
  expect_mistake("solve points.txt --algorithm delaunay --threads 0", "--threads");
}

TEST_F(Commands, NothingIsOverwrittenByAFailure) {
  write("p.txt", "precious");
  expect_mistake("generate uniform --n 1 -o p.txt", "3");
  expect_mistake("generate uniform --n 5 -o no/such/folder/p.txt", "no/such/folder");
  expect_mistake("generate uniform --n 5 -o /dev/full", "/dev/full");
  expect_mistake("generate uniform --n 5 -o p.doc", "p.doc");
  EXPECT_EQ(read("p.txt"), "precious");
}

TEST_F(Commands, AnExportDoesNotTakeTheHistorysPlace) {
  write("h.sqlite", "precious");
  expect_mistake("history export --csv --history h.sqlite -o ./h.sqlite", "would overwrite the input (h.sqlite)");
  EXPECT_EQ(read("h.sqlite"), "precious");
}

TEST_F(Commands, MistakesInStudies) {
  write("bad.toml",
        "name = \"bad\"\nsummary = \"x\"\nfamilies = [\"uniform\"]\nsizes = [10]\nalgorithms = [\"*\"]\ntime = 3\n");
  expect_mistake("run bad.toml", "bad.toml:6: a study has no key 'time'");
  write("bad.toml", "name = \"bad\nsummary = 3\n");
  expect_mistake("run bad.toml", "bad.toml:1: not valid TOML");
  write("bad.toml", "name = \"bad\"\nsummary = \"x\"\nfamilies = [\"uniform\"]\nsizes = [10]\nalgorithms = [\"no\"]\n");
  expect_mistake("run bad.toml", "bad.toml:5: unknown algorithm 'no'");
  expect_mistake("run missing.toml", "missing.toml");
  expect_mistake("run no_such_study", "claims, claims_full");
  EXPECT_FALSE(exists("results"));
}

TEST_F(Commands, ARunWithFailuresEndsWithOne) {
  write("start.csv", "0,1,2\n");
  write("s.toml",
        "name = \"s\"\nsummary = \"x\"\nfamilies = [\"uniform\"]\nsizes = [8]\nmin_time_s = 0.001\n"
        "algorithms = [\"delaunay\", { name = \"flip_naive\", parameters = { start = \"start.csv\" } }]\n"
        "[optimum]\nseek = false\n");
  const CommandResult result = mwt("run s.toml");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.output.find("1 of 2 runs failed; the table above names them\n"), std::string::npos) << result.output;
  EXPECT_EQ(result.errors, "");
}

TEST_F(Commands, HelpIsNoMistake) {
  EXPECT_EQ(mwt("--help").exit_code, 0);
  const CommandResult help = mwt("solve --help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.output.find("--with-optimum"), std::string::npos);
}

TEST_F(Commands, ProgramsPrintTheirVersion) {
  EXPECT_EQ(run("--version"), "mwt " + version() + "\n");
  EXPECT_EQ(shell(MWT_BENCHMARK_EXECUTABLE " --version >.out"), 0);
  EXPECT_EQ(read(".out"), "mwt_benchmark " + version() + "\n");
}

TEST_F(Commands, GeneratedPointsComeBack) {
  EXPECT_EQ(mwt("generate uniform --n 50 --seed 7 -o p.json").exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(read("p.json"))["points"].size(), 50u);
  EXPECT_EQ(mwt("generate uniform --n 50 --seed 7 -o -").output, mwt("generate uniform --n 50 --seed 7 -o -").output);
  EXPECT_EQ(mwt("generate report_example -o r.txt").exit_code, 0) << "a named instance needs no --n";
}

TEST_F(Commands, ListsAreCompleteJson) {
  const auto list = nlohmann::json::parse(mwt("list algorithms --json").output);
  ASSERT_EQ(list.size(), algorithms().size());
  for (std::size_t i = 0; i < list.size(); ++i) EXPECT_EQ(list[i]["name"], algorithms()[i].name);
  const auto families = nlohmann::json::parse(mwt("list generators --json").output);
  ASSERT_EQ(families.size(), generators().size());
  const auto studies = nlohmann::json::parse(mwt("list studies --json").output);
  EXPECT_TRUE(std::ranges::any_of(studies, [](const auto& study) { return study["name"] == "nightly"; }));
  EXPECT_NE(mwt("list generators").output.find("uniform"), std::string::npos);
}

TEST_F(Commands, CheckSaysWhichRuleBroke) {
  write("p.txt", "0 0\n1 0\n1 1\n0 1\n1 0\n");
  write("good.csv", "a,b,c\n0,1,2\n0,2,3\n");
  write("duplicate.csv", "0,4,2\n0,2,3\n");
  write("flipped.csv", "0,1,2\n0,3,2\n");
  write("range.csv", "0,1,2\n0,2,9\n");
  write("words.csv", "0,1,2\n0,x,3\n");
  EXPECT_EQ(mwt("check p.txt good.csv").exit_code, 0);
  EXPECT_EQ(mwt("check p.txt duplicate.csv").exit_code, 0) << "a corner at a duplicate is the point itself";
  const CommandResult flipped = mwt("check p.txt flipped.csv");
  EXPECT_EQ(flipped.exit_code, 1);
  EXPECT_NE(flipped.output.find("strictly_counter_clockwise"), std::string::npos) << flipped.output;
  const CommandResult range = mwt("check p.txt range.csv");
  EXPECT_EQ(range.exit_code, 1);
  EXPECT_NE(range.output.find("corner 9"), std::string::npos) << range.output;
  expect_mistake("check p.txt words.csv", "words.csv:2");
  expect_mistake("check - -", "standard input can be read once");
}

TEST_F(Commands, AOneBasedTriangleFileIsReadEverywhere) {
  write("p.txt", "0 0\n1 0\n1 1\n0 1\n");
  write("t.csv", "a,b,c\n1,2,3\n1,3,4\n");
  EXPECT_EQ(run("check p.txt t.csv"), "valid (corners counted from 1)\n");
  run("draw p.txt t.csv t.csv -o o.svg");
  run("solve p.txt --algorithm flip --param start=t.csv");
  write("r.csv", "a,b,c\n0,1,2\n0,2,9\n");
  const std::string words = "triangle 1 has corner 9, but points go from 0 to 3\n";
  expect_mistake("draw p.txt r.csv -o o.svg", words);
  expect_mistake("solve p.txt --algorithm flip --param start=r.csv", words);
}

TEST_F(Commands, ListsFitTheirWidth) {
  const auto widest = [&](const std::string& width) {
    std::size_t most = 0;
    EXPECT_EQ(shell("COLUMNS=" + width + " " MWT_EXECUTABLE " list algorithms >.out"), 0);
    for (const std::string& line : split(read(".out"), '\n')) most = std::max(most, line.size());
    return most;
  };
  EXPECT_LE(widest("80"), 80U);
  EXPECT_LE(widest("100"), 100U);
  EXPECT_GT(widest(""), 200U) << "whole lines for pipes and files";
  EXPECT_GT(widest("x"), 200U);
}

// "cannot make absolute path" was an internal failure.
TEST_F(Commands, AStudyFileOfTheCurrentFolderMayHaveCommands) {
  write("own.toml",
        "name = 'own'\nsummary = 's'\nfamilies = ['uniform']\nsizes = [10]\n"
        "algorithms = [{ name = 'mine', command = ['sh', '-c', 'echo 0,1,2'] }]\n");
  EXPECT_NE(run("run own.toml --dry-run").find("1 instances, 1 runs"), std::string::npos);
}

// "this mwt does not plan its run": the command was sought beside the copy of the study file.
TEST_F(Commands, ShardsOfAStudyWithCommandsAreMerged) {
  write("own.toml",
        "name = 'own'\nsummary = 's'\nfamilies = ['uniform']\nsizes = [10, 12]\n"
        "algorithms = [{ name = 'mine', command = ['./mine.sh'] }]\n");
  write("mine.sh", "#!/bin/sh\necho 0,1,2\n");
  EXPECT_EQ(shell("chmod +x mine.sh"), 0);
  for (const std::string number : {"1", "2"}) {
    EXPECT_EQ(mwt("run own.toml --shard " + number + "/2 --out part" + number).exit_code, 1) << "no triangulation";
  }
  expect_mistake("merge part1 part2 -o whole", "--study");
  EXPECT_NE(run("merge part1 part2 -o whole --study own.toml").find("2 runs of 2 folders joined"), std::string::npos);
  write("own.toml", read("own.toml") + "# another\n");
  expect_mistake("merge part1 part2 -o again --study own.toml", "differs from the study.toml of part1");
}

TEST_F(Commands, AClosedOrFullStandardOutputIsAMistake) {
  EXPECT_EQ(shell(MWT_EXECUTABLE " list generators >/dev/full 2>.err"), 2);
  EXPECT_TRUE(read(".err").starts_with("mwt: standard output")) << read(".err");
}

}  // namespace
}  // namespace mwt
