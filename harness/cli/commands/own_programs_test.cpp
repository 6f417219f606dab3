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

}  // namespace
}  // namespace mwt
