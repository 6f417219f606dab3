#include "harness/tracking/history/history.h"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "base/error.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/tracking/testing/synthetic_nightly_runs.h"

namespace mwt {
namespace {

using testing::TestFolder;
using testing::write_text;

NightlyRun small_nightly_run(int number) {
  NightlyRun nightly_run{testing::synthetic_commit(number),        "env", "Abacus", "nightly", "c",
                         "2026-01-" + std::to_string(10 + number), {}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    nightly_run.values.push_back({{"greedy", "k=1", "uniform", "", 100, seed, 1}, "wall_time_s", 0.1 * number, 3});
  nightly_run.values.push_back({{"flip", "", "uniform", "", 100, ~std::uint64_t{0}, 2}, "failures", 0.5, 2});
  return nightly_run;
}

class HistoryFile : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path() const { return folder_.path("history.sqlite"); }
  TestFolder folder_;
};

void expect_equal(const NightlyRun& a, const NightlyRun& b) {
  EXPECT_EQ(a.git_commit, b.git_commit);
  EXPECT_EQ(a.environment, b.environment);
  EXPECT_EQ(a.machine, b.machine);
  EXPECT_EQ(a.study, b.study);
  EXPECT_EQ(a.recorded_at, b.recorded_at);
  EXPECT_EQ(a.values.size(), b.values.size());
}

TEST_F(HistoryFile, GivesBackWhatItGot) {
  History(path(), History::Mode::write).add(small_nightly_run(1));
  const std::vector<NightlyRun> nightly_runs = History(path(), History::Mode::read).nightly_runs();
  ASSERT_EQ(nightly_runs.size(), 1u);
  expect_equal(nightly_runs[0], small_nightly_run(1));
  EXPECT_EQ(nightly_runs[0].values[0].cell, small_nightly_run(1).values.back().cell)
      << "ordered by algorithm; all seeds come back";
  EXPECT_EQ(nightly_runs[0].values[1].value, 0.1);
  EXPECT_EQ(nightly_runs[0].values[1].runs, 3u);
}

TEST_F(HistoryFile, IsIdempotentPerCommitEnvironmentAndStudy) {
  History history(path(), History::Mode::write);
  EXPECT_EQ(history.add(small_nightly_run(1)), History::Added::as_new);
  EXPECT_EQ(history.add(small_nightly_run(1)), History::Added::unchanged);
  NightlyRun other = small_nightly_run(1);
  other.values[3].value = 7;
  other.recorded_at = "2026-02-01";
  EXPECT_EQ(history.add(other), History::Added::replaced);
  EXPECT_EQ(history.add(small_nightly_run(1)), History::Added::outdated);
  other.environment = "elsewhere";
  EXPECT_EQ(history.add(other), History::Added::as_new);
  const std::vector<NightlyRun> nightly_runs = history.nightly_runs();
  ASSERT_EQ(nightly_runs.size(), 2u);
  for (const NightlyRun& nightly_run : nightly_runs) {
    EXPECT_EQ(nightly_run.values.size(), small_nightly_run(1).values.size());
    EXPECT_EQ(nightly_run.recorded_at, "2026-02-01");
  }
}

// A changed study under the same name used to take the place of the old one.
TEST_F(HistoryFile, AnotherConfigurationIsAnotherNight) {
  History history(path(), History::Mode::write);
  EXPECT_EQ(history.add(small_nightly_run(1)), History::Added::as_new);
  NightlyRun changed = small_nightly_run(1);
  changed.configuration = "d";
  changed.values.pop_back();
  EXPECT_EQ(history.add(changed), History::Added::as_another);
  EXPECT_EQ(history.add(changed), History::Added::unchanged);
  const std::vector<NightlyRun> nightly_runs = history.nightly_runs();
  ASSERT_EQ(nightly_runs.size(), 2u);
  EXPECT_EQ(nightly_runs[0].values.size(), small_nightly_run(1).values.size());
  EXPECT_EQ(nightly_runs[0].configuration, "c");
  EXPECT_EQ(nightly_runs[1].values.size(), small_nightly_run(1).values.size() - 1);
}

// As version 1 of the program left it: two nightly runs of two commits.
constexpr const char* kVersion1 =
    "CREATE TABLE night (id INTEGER PRIMARY KEY, git_commit TEXT NOT NULL, environment TEXT NOT NULL, "
    "study TEXT NOT NULL, machine TEXT NOT NULL, recorded_at TEXT NOT NULL, UNIQUE (git_commit, environment, study));"
    "CREATE TABLE cell (id INTEGER PRIMARY KEY, algorithm TEXT NOT NULL, params TEXT NOT NULL, generator TEXT NOT "
    "NULL, "
    "generator_params TEXT NOT NULL, n INTEGER NOT NULL, seed INTEGER NOT NULL, threads INTEGER NOT NULL, "
    "UNIQUE (algorithm, params, generator, generator_params, n, seed, threads));"
    "CREATE TABLE value (night INTEGER NOT NULL REFERENCES night (id), cell INTEGER NOT NULL REFERENCES "
    "cell (id), "
    "measure TEXT NOT NULL, value REAL NOT NULL, runs INTEGER NOT NULL, PRIMARY KEY (night, cell, measure)) "
    "WITHOUT "
    "ROWID;"
    "INSERT INTO cell VALUES (1, 'greedy', '', 'uniform', '', 100, 1, 1);"
    "INSERT INTO night VALUES (1, 'a', 'env', 'nightly', 'Abacus', '2026-01-01');"
    "INSERT INTO night VALUES (2, 'b', 'env', 'nightly', 'Abacus', '2026-01-02');"
    "INSERT INTO value VALUES (1, 1, 'wall_time_s', 0.5, 3); INSERT INTO value VALUES (2, 1, 'wall_time_s', 0.25, 3);"
    "PRAGMA user_version = 1;";

TEST_F(HistoryFile, OldNamesBecomeThePresentOnes) {
  NightlyRun old{"a", "env", "Abacus", "nightly", "c", "2026-01-01", {}};
  old.values.push_back({{"greedy_report", "", "uniform", "", 100, 1, 1}, "cpu_time_s", 0.5, 3});
  NightlyRun present = old;
  present.values[0].cell.algorithm = "greedy_naive";
  EXPECT_EQ(History(path(), History::Mode::write).add(old), History::Added::as_new);
  History history(path(), History::Mode::write);
  EXPECT_EQ(history.nightly_runs().at(0).values.at(0).cell.algorithm, "greedy_naive");
  EXPECT_EQ(history.add(present), History::Added::unchanged);
}

TEST_F(HistoryFile, OneOfVersion1IsReadAndGoesOn) {
  SQLite::Database(path(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(kVersion1);
  EXPECT_EQ(History(path(), History::Mode::read).nightly_runs().size(), 2u);
  NightlyRun same{"a", "env", "Abacus", "nightly", "c", "2026-01-01", {}};
  same.values.push_back({{"greedy", "", "uniform", "", 100, 1, 1}, "wall_time_s", 0.5, 3});
  History history(path(), History::Mode::write);
  EXPECT_EQ(history.add(same), History::Added::unchanged) << "known, though without a configuration";
  same.values[0].value = 0.75;
  same.configuration = "d";
  EXPECT_EQ(history.add(same), History::Added::as_another);
  const std::vector<NightlyRun> nightly_runs = history.nightly_runs();
  ASSERT_EQ(nightly_runs.size(), 3u);
  EXPECT_EQ(nightly_runs[0].configuration, "c");
  EXPECT_EQ(nightly_runs[0].values.at(0).value, 0.5);
  EXPECT_EQ(nightly_runs[1].values.at(0).value, 0.75);
  EXPECT_EQ(nightly_runs[2].values.at(0).value, 0.25);
}

TEST_F(HistoryFile, NightsComeInTheOrderOfTimeWhateverTheOrderOfTracking) {
  History history(path(), History::Mode::write);
  for (const int number : {3, 1, 2}) history.add(small_nightly_run(number));
  const std::vector<NightlyRun> nightly_runs = history.nightly_runs();
  for (int i = 0; i < 3; ++i) expect_equal(nightly_runs[static_cast<std::size_t>(i)], small_nightly_run(i + 1));
}

// Forks a process that adds nightly runs, first to last; it exits with 0 if it could.
pid_t writer(const std::string& path, int first, int last) {
  const pid_t child = fork();
  if (child != 0) return child;
  try {
    for (int number = first; number <= last; ++number)
      History(path, History::Mode::write).add(small_nightly_run(number));
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

TEST_F(HistoryFile, ConcurrentWritersLoseNothing) {
  std::vector<pid_t> writers;
  for (int i = 0; i < 4; ++i) writers.push_back(writer(path(), 10 * i, 10 * i + 9));
  for (const pid_t child : writers) {
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(History(path(), History::Mode::read).nightly_runs().size(), 40u);
}

TEST_F(HistoryFile, AKilledWriterLeavesWholeNights) {
  for (int round = 0; round < 20; ++round) {
    const pid_t child = writer(path(), 100 * round, 100 * round + 99);
    usleep(static_cast<useconds_t>(1000 + 1700 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    for (const NightlyRun& nightly_run : History(path(), History::Mode::write).nightly_runs())
      ASSERT_EQ(nightly_run.values.size(), small_nightly_run(0).values.size());
  }
  EXPECT_EQ(History(path(), History::Mode::write).add(small_nightly_run(5000)), History::Added::as_new);
}

std::string complaint_about(const std::string& path, History::Mode mode) {
  try {
    const History history(path, mode);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_F(HistoryFile, RefusesWhatIsNoHistory) {
  EXPECT_EQ(complaint_about(path(), History::Mode::read),
            path() + ": there is no history here; mwt track FOLDER begins one");
  EXPECT_EQ(complaint_about("/no/such/folder/h.sqlite", History::Mode::write),
            "/no/such/folder/h.sqlite: unable to open database file");
  const std::string text = folder_.path("text");
  write_text(text, std::string(5000, 'x'));
  EXPECT_EQ(complaint_about(text, History::Mode::write), text + ": file is not a database");
  EXPECT_EQ(testing::read_text(text), std::string(5000, 'x'));
}

TEST_F(HistoryFile, RefusesAnotherVersion) {
  SQLite::Database(path(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("PRAGMA user_version = 3; CREATE TABLE t (x)");
  EXPECT_EQ(complaint_about(path(), History::Mode::read),
            path() + ": is no history of this program's version; choose another file with --history");
}

}  // namespace
}  // namespace mwt
