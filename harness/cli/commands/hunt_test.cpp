// `mwt hunt` from end to end.
#include <gtest/gtest.h>

#include "harness/cli/testing/commands_testing.h"
#include "harness/io/points/point_file.h"

namespace mwt {
namespace {

class HuntCommand : public testing::CommandTest {};

TEST_F(HuntCommand, WritesThePointsAndTheirAlpha) {
  const std::string output = run("hunt --algorithm greedy --n 7 --evaluations 200 -o found.txt");
  const std::string text = read("found.txt");
  EXPECT_NE(text.find("# mwt hunt 1: greedy algorithm_seed=1 n=7 seed=1"), std::string::npos) << text;
  EXPECT_NE(text.find("# alpha >= 1."), std::string::npos) << text;
  EXPECT_EQ(read_points(path("found.txt")).size(), 7U);
  EXPECT_NE(output.find("written to found.txt"), std::string::npos) << output;
}

TEST_F(HuntCommand, OverwritesNothingAndResumesWhenAsked) {
  const std::string hunt = "hunt --algorithm flip --n 6 -o found.txt --evaluations ";
  run(hunt + "50");
  expect_mistake(hunt + "90", "found.txt exists; --resume continues that hunt");
  run(hunt + "90 --resume");
  run("hunt --algorithm flip --n 6 -o other.txt --evaluations 90");
  EXPECT_EQ(read("found.txt"), read("other.txt"));
  expect_mistake("hunt --algorithm greedy --n 6 -o found.txt --resume", "state of another hunt");
}

TEST_F(HuntCommand, AKilledHuntGoesOn) {
  const std::string hunt = MWT_EXECUTABLE " hunt --algorithm greedy --n 6 --seed 3 -o found.txt";
  ASSERT_EQ(shell(hunt + " --budget 600 >/dev/null & pid=$!; "
                         "for i in $(seq 600); do [ -s found.txt.state ] && break; sleep .05; done; "
                         "kill -9 $pid; wait $pid; [ $? = 137 ]"),
            0);
  run("hunt --algorithm greedy --n 6 --seed 3 -o found.txt --budget .1 --resume");
  EXPECT_EQ(read_points(path("found.txt")).size(), 6U);
}

TEST_F(HuntCommand, MistakesGetOneLine) {
  expect_mistake("hunt --algorithm greedy", "give --n");
  expect_mistake("hunt --algorithm greedi --n 8", "unknown algorithm 'greedi'");
  expect_mistake("hunt --algorithm greedy --n 8 -o found.json", "ends in .txt or .xy");
  expect_mistake("hunt --algorithm greedy --n 8 --solver flip", "not exact");
  expect_mistake("hunt --algorithm brute_force --n 40", "at most 13 points");
  expect_mistake("hunt --algorithm flip --n 8 --param start=mine.csv", "named start");
}

}  // namespace
}  // namespace mwt
