// kill -9 at random moments: nothing recorded is lost, nothing is recorded twice.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <random>

#include "harness/io/testing/folder_testing.h"
#include "harness/records/testing/records_testing.h"

namespace mwt {
namespace {

using testing::lasting;
using testing::TestFolder;

constexpr int kKills = 50;

class KillSlow : public ::testing::Test {
 protected:
  KillSlow() {
    testing::write_text(folder_.path("s.toml"), R"(name = "s"
summary = "killed again and again"
families = ["uniform", "grid", "circle"]
sizes = [10, 40]
seeds = [1, 2, 3, 4, 5]
algorithms = ["delaunay", "greedy", "flip", "patch", "exact", "brute_force"]
repetitions = 3
min_time_s = 0.001
[optimum]
sources = ["polygon_dp", "exact"]
)");
  }

  [[nodiscard]] pid_t start(const std::string& out) const {
    const std::string study = folder_.path("s.toml");
    const pid_t pid = fork();
    if (pid != 0) return pid;
    dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
    execl(MWT_EXECUTABLE, "mwt", "run", study.c_str(), "--out", out.c_str(), "--resume", "--no-cache", nullptr);
    _exit(127);
  }

  void finish(const std::string& out) const {
    int status = 0;
    waitpid(start(out), &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  }

  // Whether the study was killed before it had come to its end.
  [[nodiscard]] bool kill_after(const std::string& out, useconds_t delay) const {
    const pid_t pid = start(out);
    usleep(delay);
    kill(pid, SIGKILL);
    int status = 0;
    waitpid(pid, &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  }

  TestFolder folder_;
};

TEST_F(KillSlow, FiftyTimesAtRandomMomentsLosesAndDoublesNothing) {
  finish(folder_.path("whole"));
  const StudyRecords whole = read_records(folder_.path("whole"));
  ASSERT_GT(whole.runs.size(), 200u);
  std::mt19937_64 random(1);
  int kills = 0;
  for (int round = 0; kills < kKills; ++round) {
    const std::string out = folder_.path("killed" + std::to_string(round));
    // Short and long lives: in the search for optima, in the middle of the runs, near the end.
    while (kills < kKills && kill_after(out, static_cast<useconds_t>(5000 + random() % 400000))) ++kills;
    finish(out);
    const StudyRecords killed = read_records(out);
    EXPECT_EQ(lasting(run_columns(), killed.runs), lasting(run_columns(), whole.runs)) << round;
    EXPECT_EQ(lasting(instance_columns(), killed.instances), lasting(instance_columns(), whole.instances)) << round;
  }
}

}  // namespace
}  // namespace mwt
