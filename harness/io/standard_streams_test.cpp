// Runs both programs with standard streams closed.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/cli/testing/commands_testing.h"

namespace mwt {
namespace {

class StandardStreams : public testing::CommandTest {
 protected:
  // "<&- 2>&-": all combinations of closed ones.
  [[nodiscard]] static std::vector<std::string> closings() {
    std::vector<std::string> result;
    for (int closed = 0; closed < 8; ++closed) {
      result.push_back(std::string((closed & 1) != 0 ? " <&-" : "") + ((closed & 2) != 0 ? " >&-" : " >.out") +
                       ((closed & 4) != 0 ? " 2>&-" : " 2>.err"));
    }
    return result;
  }
};

TEST_F(StandardStreams, WhatIsPrintedLandsInNoFile) {
  write("p.txt", "0 0\n4 0\n4 4\n0 4\n2 1\n");
  run("solve p.txt --algorithm greedy --triangles right.csv --edges right_edges.csv --svg right.svg");
  run("draw p.txt right.csv -o drawn.svg");
  for (const std::string& closing : closings()) {
    ASSERT_EQ(
        shell(MWT_EXECUTABLE " solve p.txt --algorithm greedy --triangles t.csv --edges e.csv --svg s.svg" + closing),
        0)
        << closing;
    EXPECT_EQ(read("t.csv"), read("right.csv")) << closing;
    EXPECT_EQ(read("e.csv"), read("right_edges.csv")) << closing;
    EXPECT_EQ(read("s.svg"), read("right.svg")) << closing;
    ASSERT_EQ(shell(MWT_EXECUTABLE " draw p.txt right.csv -o d.svg" + closing), 0) << closing;
    EXPECT_EQ(read("d.svg"), read("drawn.svg")) << closing;
  }
}

TEST_F(StandardStreams, AStudyKeepsItsFiles) {
  write("tiny.toml",
        "name = \"tiny\"\nsummary = \"x\"\nfamilies = [\"uniform\"]\nsizes = [8]\nalgorithms = [\"delaunay\"]\n"
        "min_time_s = 0.001\n");
  for (const std::string& closing : closings()) {
    ASSERT_EQ(shell("rm -rf records; " MWT_EXECUTABLE " run tiny.toml --out records" + closing), 0) << closing;
    EXPECT_EQ(read("records/study.toml"), read("tiny.toml")) << closing;
    ASSERT_EQ(shell(MWT_EXECUTABLE " run tiny.toml --out records --resume" + closing), 0) << closing;
    EXPECT_EQ(mwt("report records").exit_code, 0) << closing;
  }
}

TEST_F(StandardStreams, ReadingAClosedOneIsReadingNothing) {
  EXPECT_EQ(shell(MWT_EXECUTABLE " solve - --algorithm greedy <&- 2>.err"), 2);
  EXPECT_EQ(read(".err"), "mwt: standard input: no points in it; write one \"x y\" per line\n");
}

TEST_F(StandardStreams, BenchmarksKeepTheirFile) {
  for (const std::string& closing : closings()) {
    ASSERT_EQ(shell(MWT_BENCHMARK_EXECUTABLE
                    " --benchmark_filter='^delaunay/uniform/10$' --benchmark_min_time=0.001 --benchmark_out=b.json" +
                    closing),
              0)
        << closing;
    EXPECT_EQ(nlohmann::json::parse(read("b.json"))["benchmarks"].size(), 1U) << closing;
  }
}

}  // namespace
}  // namespace mwt
