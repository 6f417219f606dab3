// Programs of others, as README.md says how to race them.
#include <gtest/gtest.h>

#include "harness/cli/testing/commands_testing.h"

namespace mwt {
namespace {

class OwnPrograms : public testing::CommandTest {};

TEST_F(OwnPrograms, AStudyFileInTheWorkingFolder) {
  write("mine.toml",
        "name = \"mine\"\nsummary = \"My program beside greedy\"\nfamilies = [\"uniform\"]\nsizes = [10]\n"
        "algorithms = [\"greedy\", { name = \"mine\", command = [\"./mine.sh\"] }]\n");
  write("mine.sh", "#!/bin/sh\nexec " MWT_SOURCE_DIR "/library/examples/rivals/fan_sweep.sh\n");
  ASSERT_EQ(shell("chmod +x mine.sh"), 0);
  EXPECT_NE(run("run mine.toml --quiet").find("records: results/mine/runs.csv"), std::string::npos);
  EXPECT_EQ(shell("[ $(grep -c ,ok, results/mine/runs.csv) = 2 ]"), 0);
}

// mwt has no chance to clean up; the process that it left on guard does.
TEST_F(OwnPrograms, DieWithMwtWhenItIsKilled) {
  write("mine.toml",
        "name = \"mine\"\nsummary = \"A program that detaches itself\"\nfamilies = [\"uniform\"]\nsizes = [10]\n"
        "algorithms = [{ name = \"mine\", command = [\"sh\", \"-c\", "
        "\"setsid sh -c 'trap : TERM HUP INT; touch " +
            path("begun") + "; sleep 987654321' & exec sleep 987654321\"] }]\n");
  const std::string running = "grep -sqz '^98765432[1]$' /proc/[0-9]*/cmdline";
  ASSERT_EQ(shell(MWT_EXECUTABLE
                  " run mine.toml --quiet >.out 2>&1 & pid=$!; "
                  "for i in $(seq 300); do [ -e begun ] && break; sleep 0.1; done; [ -e begun ] && kill -9 $pid"),
            0);
  EXPECT_EQ(shell("for i in $(seq 300); do " + running + " || break; sleep 0.1; done; ! " + running), 0);
}

}  // namespace
}  // namespace mwt
