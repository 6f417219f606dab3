#include "harness/cli/testing/commands_testing.h"

namespace mwt {
namespace {

class ConvertCommand : public testing::CommandTest {};

TEST_F(ConvertCommand, ReadsWhatOthersWrite) {
  write("p.json", "{\"points_x\": [0, 1, 0.5], \"points_y\": [0, 0, 1]}");
  EXPECT_EQ(mwt("convert p.json p.csv").errors, "3 points\n");
  EXPECT_EQ(read("p.csv"), "x,y\n0,0\n1,0\n0.5,1\n");
  ASSERT_EQ(shell("gzip -k p.csv"), 0);
  EXPECT_EQ(run("convert p.csv.gz -"), "0 0\n1 0\n0.5 1\n");
  write("t.csv", "id,east,north\n5,0,0\n6,1,0\n7,0.5,1\n");
  EXPECT_EQ(run("convert t.csv - --columns east,north"), "0 0\n1 0\n0.5 1\n");
  EXPECT_EQ(run("solve t.csv --algorithm greedy --columns 2,3 --triangles -"), "a,b,c\n0,1,2\n");
}

TEST_F(ConvertCommand, MistakesAreReported) {
  write("p.txt", "0 0\n1 0\n0 1\n");
  expect_mistake("convert p.txt p.npy", "points are written as");
  expect_mistake("convert p.txt p.txt", "p.txt");
  expect_mistake("convert none.txt q.txt", "no such file");
  expect_mistake("convert p.txt q.txt --columns x", "does not name two columns");
}

TEST_F(ConvertCommand, CheckJudgesSolutionsOfOthers) {
  write("p.txt", "0 0\n1 0\n1 1\n0 1\n");
  write("e.json", "{\"edges\": [[0, 1], [1, 2], [2, 3], [0, 3], [0, 2]]}");
  EXPECT_EQ(run("check p.txt e.json"), "valid (edges)\n");
  write("t.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
  EXPECT_EQ(run("check p.txt t.ele"), "valid (corners counted from 1)\n");
  write("bad.txt", "1 2\n2 3\n3 4\n4 1\n");
  const auto result = mwt("check p.txt bad.txt");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(
      result.output.starts_with("invalid (edges; corners counted from 1): the triangles that the edges bound: "))
      << result.output;
}

}  // namespace
}  // namespace mwt
