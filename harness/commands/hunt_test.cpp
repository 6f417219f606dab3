// `mwt hunt` from end to end.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "geometry/point_file.h"
#include "harness/test_support.h"

namespace mwt {
namespace {

using testing::read_text;
using testing::TemporaryFolder;
using testing::write_text;

class HuntCommand : public ::testing::Test {
 protected:
  [[nodiscard]] int shell(const std::string& command) const {
    return WEXITSTATUS(std::system(("cd " + folder_.path("") + " && { " + command + "; }").c_str()));
  }
  [[nodiscard]] int mwt(const std::string& arguments) const {
    return shell(MWT_EXECUTABLE " " + arguments + " >" + folder_.path(".out") + " 2>" + folder_.path(".err"));
  }
  [[nodiscard]] std::string error() const { return read_text(folder_.path(".err")); }

  TemporaryFolder folder_;
};

TEST_F(HuntCommand, WritesThePointsAndTheirAlpha) {
  ASSERT_EQ(mwt("hunt --algorithm greedy --n 7 --evaluations 200 -o found.txt"), 0) << error();
  const std::string text = read_text(folder_.path("found.txt"));
  EXPECT_NE(text.find("# mwt hunt 1: greedy algorithm_seed=1 n=7 seed=1"), std::string::npos) << text;
  EXPECT_NE(text.find("# alpha >= 1."), std::string::npos) << text;
  EXPECT_EQ(read_points(folder_.path("found.txt")).size(), 7U);
  EXPECT_NE(read_text(folder_.path(".out")).find("written to found.txt"), std::string::npos);
}

TEST_F(HuntCommand, OverwritesNothingAndResumesWhenAsked) {
  const std::string hunt = "hunt --algorithm flip --n 6 -o found.txt --evaluations ";
  ASSERT_EQ(mwt(hunt + "50"), 0) << error();
  EXPECT_EQ(mwt(hunt + "90"), 2);
  EXPECT_NE(error().find("found.txt exists; --resume continues that hunt"), std::string::npos) << error();
  ASSERT_EQ(mwt(hunt + "90 --resume"), 0) << error();
  ASSERT_EQ(mwt("hunt --algorithm flip --n 6 -o other.txt --evaluations 90"), 0) << error();
  EXPECT_EQ(read_text(folder_.path("found.txt")), read_text(folder_.path("other.txt")));
  EXPECT_EQ(mwt("hunt --algorithm greedy --n 6 -o found.txt --resume"), 2);
  EXPECT_NE(error().find("state of another hunt"), std::string::npos) << error();
}

TEST_F(HuntCommand, AKilledHuntGoesOn) {
  const std::string hunt = std::string(MWT_EXECUTABLE) + " hunt --algorithm greedy --n 6 --seed 3 -o found.txt";
  ASSERT_EQ(shell(hunt + " --budget 600 >/dev/null & pid=$!; "
                         "for i in $(seq 600); do [ -s found.txt.state ] && break; sleep .05; done; "
                         "kill -9 $pid; wait $pid; [ $? = 137 ]"),
            0);
  EXPECT_EQ(mwt("hunt --algorithm greedy --n 6 --seed 3 -o found.txt --budget .1 --resume"), 0) << error();
  EXPECT_EQ(read_points(folder_.path("found.txt")).size(), 6U);
}

TEST_F(HuntCommand, MistakesGetOneLine) {
  const auto complaint = [&](const std::string& arguments) {
    EXPECT_EQ(mwt("hunt " + arguments), 2);
    return error();
  };
  EXPECT_NE(complaint("--algorithm greedy").find("give --n"), std::string::npos);
  EXPECT_NE(complaint("--algorithm greedi --n 8").find("unknown algorithm 'greedi'"), std::string::npos);
  EXPECT_NE(complaint("--algorithm greedy --n 8 -o found.json").find("ends in .txt or .xy"), std::string::npos);
  EXPECT_NE(complaint("--algorithm greedy --n 8 --solver flip").find("not exact"), std::string::npos);
  EXPECT_NE(complaint("--algorithm brute_force --n 40").find("at most 13 points"), std::string::npos);
  EXPECT_NE(complaint("--algorithm flip --n 8 --param start=mine.csv").find("named start"), std::string::npos);
}

}  // namespace
}  // namespace mwt
