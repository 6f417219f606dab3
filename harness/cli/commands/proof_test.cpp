// Proofs as users make and check them: mwt solve --proof, and the program mwt_verify.
#include <gtest/gtest.h>

#include "harness/cli/testing/commands_testing.h"

namespace mwt {
namespace {

class ProofCommands : public testing::CommandTest {
 protected:
  void SetUp() override {
    write("p.txt", "0 0\n4 0\n4 4\n0 4\n2 1\n1 3\n3 2.5\n");
    write("other.txt", "0 0\n4 0\n4 4\n0 4\n2 1\n1 3\n3 2.4\n");
  }

  [[nodiscard]] testing::CommandResult verify(const std::string& arguments) const {
    const int exit_code = shell(MWT_VERIFY_EXECUTABLE " " + arguments + " >.out 2>.err");
    return {exit_code, read(".out"), read(".err")};
  }
};

TEST_F(ProofCommands, AProofIsVerified) {
  static_cast<void>(run("solve p.txt --algorithm exact --proof p.mwtproof"));
  const auto result = verify("p.txt p.mwtproof");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.output.starts_with("VERIFIED weight in [")) << result.output;
  EXPECT_NE(result.output.find("], optimal\n"), std::string::npos) << result.output;
}

TEST_F(ProofCommands, WhatFitsToNoPointsIsRefused) {
  static_cast<void>(run("solve p.txt --algorithm exact --proof p.mwtproof"));
  const auto result = verify("other.txt p.mwtproof");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.output, "REFUSED instance: the proof is about other points\n");
}

TEST_F(ProofCommands, UnusableFilesAreMistakes) {
  EXPECT_EQ(verify("p.txt").exit_code, 2);
  EXPECT_EQ(verify("p.txt p.txt").exit_code, 2);
  EXPECT_EQ(verify("p.txt missing").exit_code, 2);
  EXPECT_EQ(verify("missing p.txt").exit_code, 2);
  EXPECT_EQ(verify("p.txt .").exit_code, 2);
  ASSERT_EQ(shell("mkfifo pipe"), 0);
  EXPECT_EQ(verify("p.txt pipe").exit_code, 2) << "not opened: nobody writes";
}

TEST_F(ProofCommands, AVerdictThatCannotBePrintedIsNone) {
  static_cast<void>(run("solve p.txt --algorithm exact --proof p.mwtproof"));
  ASSERT_EQ(shell("cp p.mwtproof copy"), 0);
  EXPECT_EQ(shell(MWT_VERIFY_EXECUTABLE " p.txt p.mwtproof >/dev/full 2>.err"), 2);
  EXPECT_NE(read(".err").find("standard output cannot be written"), std::string::npos);
  EXPECT_EQ(shell(MWT_VERIFY_EXECUTABLE " other.txt p.mwtproof >/dev/full 2>.err"), 2);
  EXPECT_EQ(shell(MWT_VERIFY_EXECUTABLE " p.txt p.mwtproof <&- >&- 2>&-"), 0);
  EXPECT_EQ(shell(MWT_VERIFY_EXECUTABLE " other.txt p.mwtproof <&- >&- 2>&-"), 1);
  EXPECT_EQ(shell("cmp p.mwtproof copy"), 0);
}

TEST_F(ProofCommands, BoundsArePrintedAsSuch) {
  static_cast<void>(run("generate uniform --n 2000 -o u.txt"));
  static_cast<void>(run("solve u.txt --algorithm exact --time-limit 0.000001 --proof u.mwtproof"));
  const auto result = verify("u.txt u.mwtproof");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.output.find("], bounded\n"), std::string::npos) << result.output;
}

TEST_F(ProofCommands, StudiesKeepThemAndFailIfOneIsRefused) {
  write("study.toml",
        "name = 's'\nsummary = 't'\nfamilies = ['uniform']\nsizes = [40]\nalgorithms = ['sweep']\n[optimum]\nsources = "
        "['exact']\nproofs = true\n");
  static_cast<void>(run("run study.toml --out results"));
  static_cast<void>(run("generate uniform --n 40 --seed 1 -o u.txt"));
  ASSERT_EQ(shell("mv results/proofs/*.mwtproof u.mwtproof"), 0);
  const auto result = verify("u.txt u.mwtproof");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.output.starts_with("VERIFIED weight in [")) << result.output;
  EXPECT_NE(run("report results").find("optima: 1 of 1 instances proved; mwt_verify verifies 1 of them"),
            std::string::npos);
  ASSERT_EQ(shell("sed -i 's/,optimal,,/,refused,step 1: it does not follow,/' results/instances.csv"), 0);
  const auto again = mwt("run study.toml --out results --resume");
  EXPECT_EQ(again.exit_code, 3);
  EXPECT_NE(again.output.find("refused  step 1: it does not follow"), std::string::npos) << again.output;
}

TEST_F(ProofCommands, MistakesAreReportedBeforeTheWork) {
  expect_mistake("solve p.txt --algorithm greedy --proof p.mwtproof", "greedy writes no proofs");
  expect_mistake("solve p.txt --algorithm exact --proof -", "give a file");
  expect_mistake("solve p.txt --algorithm exact --proof /dev/stdout", "give a file");
  expect_mistake("solve p.txt --algorithm exact --proof p.txt", "--proof");
  EXPECT_FALSE(exists("p.mwtproof"));
}

}  // namespace
}  // namespace mwt
