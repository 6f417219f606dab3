// What the program prints about itself: manual pages, and completion for shells.
#include <gtest/gtest.h>

#include "harness/cli/testing/commands_testing.h"

namespace mwt {
namespace {

class Documents : public testing::CommandTest {
 protected:
  // What bash offers for the last of the words.
  [[nodiscard]] std::string completed(const std::string& words) const {
    EXPECT_EQ(shell(MWT_EXECUTABLE " completion bash > complete && bash -c 'source ./complete; COMP_WORDS=(\"$@\"); "
                                   "COMP_CWORD=$(($# - 1)); _mwt; echo \"${COMPREPLY[*]}\"' bash mwt " +
                    words + " > .out"),
              0);
    std::string printed = read(".out");
    printed.pop_back();
    return printed;
  }
};

TEST_F(Documents, TheManualNamesEveryOptionOfEveryCommand) {
  const std::string page = run("manual");
  EXPECT_TRUE(page.find(".TH MWT 1") != std::string::npos) << page.substr(0, 200);
  const std::string help = run("solve --help");
  for (std::size_t at = help.find("\n  --"); at != std::string::npos; at = help.find("\n  --", at + 1)) {
    std::string option = help.substr(at + 3, help.find(' ', at + 3) - at - 3);
    for (std::size_t i = 0; i < option.size(); ++i) {
      if (option[i] == '-') option.insert(i++, "\\");
    }
    EXPECT_NE(page.find("\\fB" + option + "\\fR"), std::string::npos) << option;
  }
  EXPECT_NE(run("manual mwt_verify").find(".TH MWT_VERIFY 1"), std::string::npos);
  expect_mistake("manual cat", "known: mwt, mwt_verify");
}

TEST_F(Documents, BashCompletesCommandsOptionsAndNames) {
  write("points.txt", "");
  ASSERT_EQ(shell("mkdir records"), 0);
  EXPECT_EQ(completed("so"), "solve");
  EXPECT_EQ(completed("--v"), "--version");
  EXPECT_EQ(completed("solve points.txt --t"), "--threads --time-limit --triangles");
  EXPECT_EQ(completed("solve points.txt --algorithm gre"), "greedy_naive greedy");
  EXPECT_EQ(completed("solve --seed 3 --algorithm = gre"), "greedy_naive greedy");
  EXPECT_EQ(completed("solve po"), "points.txt");
  EXPECT_EQ(completed("check --columns x,y - po"), "points.txt");
  EXPECT_EQ(completed("report r"), "records");
  EXPECT_EQ(completed("merge records r"), "records");
  EXPECT_EQ(completed("list g"), "generators");
  EXPECT_EQ(completed("generate uniform_d"), "uniform_disc");
  EXPECT_EQ(completed("completion z"), "zsh");
  EXPECT_EQ(completed("solve points.txt --seed ''"), "");
  expect_mistake("completion fish", "known: bash, zsh");
}

TEST_F(Documents, ZshCompletionNamesTheSame) {
  const std::string script = run("completion zsh");
  EXPECT_TRUE(script.starts_with("#compdef mwt mwt_verify\n"));
  for (const char* part : {"'solve:", "--algorithm[", "greedy_naive", "(-o --output)", "claims_full"})
    EXPECT_NE(script.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace mwt
