#include "harness/run/command/command.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <thread>

#include "base/error.h"
#include "geometry/checker.h"
#include "geometry/weight.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/run/command/command_folder.h"

namespace mwt {
namespace {

using testing::read_text;
using testing::TestFolder;
using testing::write_text;

const std::vector<Point> kSquare = {{0, 0}, {1, 0}, {1, 1.25}, {0, 1}};

// A shell script as an algorithm.
AlgorithmInfo script(const std::string& text, const std::map<std::string, std::string>& parameters = {}) {
  ExternalCommand command;
  command.words = {"sh", "-c", text};
  return algorithm_of("rival", command, parameters);
}

struct Outcome {
  RunStatus status = RunStatus::ok;
  std::string message;
  Solution solution;
  std::optional<OutsideCost> cost;
};

Outcome run(const AlgorithmInfo& algorithm, const std::map<std::string, std::string>& parameters = {},
            const Deadline& deadline = {}) {
  Context context;
  context.seed = 7;
  context.parameters = Parameters(algorithm.name, algorithm.parameters, parameters);
  context.deadline = deadline;
  Outcome outcome;
  try {
    outcome.solution = algorithm.function(kSquare, context);
  } catch (const CommandFailure& failure) {
    outcome.status = failure.status();
    outcome.message = failure.what();
  } catch (const NotApplicable& reason) {
    outcome.status = RunStatus::not_applicable;
    outcome.message = reason.what();
  }
  outcome.cost = context.outside;
  return outcome;
}

Outcome run_script(const std::string& text) { return run(script(text)); }

std::string mistake(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

// Those of this process.
std::size_t command_folders() {
  std::size_t count = 0;
  const std::string own = '-' + std::to_string(getpid()) + '-';
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::temp_directory_path())) {
    const std::string name = entry.path().filename().string();
    count += name.starts_with("mwt-command-") && name.find(own) != std::string::npos ? 1 : 0;
  }
  return count;
}

TEST(ExternalCommands, AnswerOnStandardOutputOrInAFile) {
  for (const char* text :
       {"cat > /dev/null; echo 0,1,2; echo 0,2,3", "echo '2 1 0' > {triangles}; echo 3 2 0 >> {triangles}",
        "printf '0,1\n1,2\n2,3\n0,3\n0,2\n' > {edges}", "printf 'a,b,c\n0,1,2\n0,2,3\n'"}) {
    const Outcome outcome = run_script(text);
    EXPECT_EQ(outcome.status, RunStatus::ok) << text << ": " << outcome.message;
    EXPECT_FALSE(find_violation(kSquare, outcome.solution.triangulation)) << text;
    EXPECT_GT(outcome.cost.value().wall_time_s, 0);
    EXPECT_GT(outcome.cost.value().peak_rss_bytes, 0u);
  }
  EXPECT_EQ(command_folders(), 0u) << "nothing is left";
}

TEST(ExternalCommands, GetPointsExactlyAndAllPlaceholders) {
  const TestFolder folder;
  ExternalCommand command;
  command.words = {"sh",
                   "-c",
                   "cat {points} > seen; echo \"$@\" >> seen; echo $OWN $PWD >> seen; echo 0,1,2; echo 0,2,3",
                   "sh",
                   "{seed}",
                   "{threads}",
                   "{n}",
                   "{time_limit}",
                   "{k}",
                   "{{k}",
                   "a{k}b",
                   "{ k }"};
  command.folder = folder.path("");
  command.environment = {{"OWN", "<{k}>"}};
  EXPECT_EQ(run(algorithm_of("rival", command, {{"k", "3"}}), {{"k", "5"}}).status, RunStatus::ok);
  const std::string seen = read_text(folder.path("seen"));
  EXPECT_TRUE(seen.starts_with("0 0\n1 0\n1 1.25\n0 1\n7 1 4 1000000000 5 {k} a5b { k }\n<5> ")) << seen;
}

TEST(ExternalCommands, StateMoreInTheLastLine) {
  const Outcome outcome = run_script(
      "echo 0,1,2; echo 0,2,3; echo '{\"time_s\": 0.5, \"lower_bound\": 3.25, \"stopped_early\": true, \"counters\": "
      "{\"flips\": 4}}'");
  ASSERT_EQ(outcome.status, RunStatus::ok) << outcome.message;
  EXPECT_EQ(outcome.solution.counters, (std::map<std::string, double>{{"flips", 4}, {"stated_time_s", 0.5}}));
  EXPECT_EQ(outcome.solution.claimed_lower, 3.25);
  EXPECT_FALSE(outcome.solution.optimum) << "nobody certifies it";
  EXPECT_EQ(outcome.solution.stop_reason, StopReason::deadline);
  for (const char* statement : {"{\"time_s\": }", "{\"time_s\": \"1\"}", "{\"lower\": 1}", "{\"counters\": 3}", "{",
                                "{\"time_s\": 1e999}", "{\"stopped_early\": 1}"}) {
    const Outcome refused = run_script(std::string("echo 0,1,2; echo 0,2,3; echo '") + statement + "'");
    EXPECT_EQ(refused.status, RunStatus::invalid_output) << statement;
    EXPECT_NE(refused.message, "");
  }
}

struct Misbehaviour {
  std::string text;
  RunStatus status;
  std::string part;  // of the message
};

class MisbehavingExternalCommands : public ::testing::TestWithParam<Misbehaviour> {};

TEST_P(MisbehavingExternalCommands, HaveAStatusAndAMessage) {
  const Outcome outcome = run_script(GetParam().text);
  EXPECT_EQ(outcome.status, GetParam().status) << outcome.message;
  EXPECT_NE(outcome.message.find(GetParam().part), std::string::npos) << outcome.message;
  EXPECT_EQ(outcome.message.find('\n'), std::string::npos);
  EXPECT_EQ(command_folders(), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    AllKinds, MisbehavingExternalCommands,
    ::testing::Values(Misbehaviour{"echo no luck >&2; exit 3", RunStatus::error,
                                   "it exits with 3; standard error: no luck"},
                      Misbehaviour{"echo not such points >&2; exit 77", RunStatus::not_applicable, "not such points"},
                      Misbehaviour{"echo MemoryError >&2; exit 1", RunStatus::out_of_memory, "MemoryError"},
                      Misbehaviour{"kill -SEGV $$", RunStatus::crashed, "signal 11"},
                      Misbehaviour{"kill -KILL $$", RunStatus::out_of_memory, "signal 9"},
                      Misbehaviour{"true", RunStatus::invalid_output, "its result cannot be read: triangles.csv"},
                      Misbehaviour{"true {triangles}", RunStatus::invalid_output, "it wrote no file"},
                      Misbehaviour{"echo what a day", RunStatus::invalid_output, "its result cannot be read"},
                      Misbehaviour{"head -c 3000 /dev/zero", RunStatus::invalid_output, "its result cannot be read"},
                      Misbehaviour{"echo hello >&2", RunStatus::invalid_output, "standard error: hello"},
                      Misbehaviour{"echo 0,1,9", RunStatus::invalid_output, "is 9, but points go from 0 to 3"},
                      Misbehaviour{"echo 1,2,3; echo 1,3,4", RunStatus::invalid_output, "perhaps it counts from 1"},
                      Misbehaviour{"echo 0,1,-2", RunStatus::invalid_output, "its result cannot be read"},
                      Misbehaviour{"echo 1,1 > {edges}", RunStatus::invalid_output, "ends where it begins"},
                      Misbehaviour{"mkdir {triangles}", RunStatus::invalid_output, "it wrote no file"}));

TEST(ExternalCommands, ThatAnswerWronglyAreLeftToTheChecker) {
  const Outcome outcome = run_script("echo 0,1,2");
  EXPECT_EQ(outcome.status, RunStatus::ok);
  EXPECT_TRUE(find_violation(kSquare, outcome.solution.triangulation));
}

TEST(ExternalCommands, AreKilledAfterTheirTimeLimit) {
  const auto begin = Context::Clock::now();
  const Outcome outcome = run(script("sleep 1000 & exec sleep 1000"), {}, begin - std::chrono::milliseconds(4900));
  EXPECT_EQ(outcome.status, RunStatus::timeout);
  EXPECT_LT(Context::Clock::now() - begin, std::chrono::seconds(60));
}

// The process whose number the file has exists no more.
void expect_gone(const std::string& file) {
  const int pid = std::stoi(read_text(file));
  EXPECT_EQ(kill(pid, 0), -1) << pid;
}

TEST(ExternalCommands, LeaveNoChildrenBehind) {
  const TestFolder folder;
  const std::string file = folder.path("pid");
  const std::string apart = "setsid sh -c 'echo $$ > " + file + "; exec sleep 1000' &";
  for (const std::string& how : {"sleep 1000 & echo $! > " + file + ";", apart, "(" + apart + ");"}) {
    std::filesystem::remove(file);
    const Outcome outcome =
        run_script(how + " while [ ! -s " + file + " ]; do sleep 0.01; done; echo 0,1,2; echo 0,2,3");
    ASSERT_EQ(outcome.status, RunStatus::ok) << outcome.message;
    expect_gone(file);
  }
}

TEST(ExternalCommands, FoldersOfKilledProcessesAreRemoved) {
  namespace fs = std::filesystem;
  const pid_t child = fork();
  if (child == 0) _exit(0);
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  const CommandFolder living;
  EXPECT_EQ(command_folders(), 1u);
  const fs::path own = fs::path(living.file("")).parent_path();
  std::string name = own.filename().string();
  const std::string number = '-' + std::to_string(getpid()) + '-';
  const fs::path dead =
      own.parent_path() / name.replace(name.rfind(number), number.size(), '-' + std::to_string(child) + '-');
  fs::create_directory(dead);
  write_text((dead / "points.txt").string(), "0 0\n");
  remove_abandoned_command_folders();
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(own));
}

TEST(ExternalCommands, LongOutputIsReadFromItsEnd) {
  const Outcome outcome = run_script(
      "head -c 50000000 /dev/zero | tr '\\0' x; echo; echo '{\"time_s\": 2}'; printf '0,1,2\\n0,2,3\\n' > {triangles}");
  ASSERT_EQ(outcome.status, RunStatus::ok) << outcome.message;
  EXPECT_EQ(outcome.solution.counters.at("stated_time_s"), 2);
}

TEST(ExternalCommands, RunSideBySideInThreads) {
  std::vector<std::thread> threads;
  std::array<int, 4> well{};
  for (int& count : well) {
    threads.emplace_back([&count] {
      for (int i = 0; i < 10; ++i)
        count += run_script("sleep 0.01 & cat > /dev/null; echo 0,1,2; echo 0,2,3").status == RunStatus::ok ? 1 : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(well, (std::array<int, 4>{10, 10, 10, 10}));
}

TEST(ExternalCommands, MistakesAreReportedBeforeARun) {
  const auto entry = [](ExternalCommand command, const std::string& name = "rival") {
    return mistake([&] { static_cast<void>(algorithm_of(name, command, {{"k", "1"}})); });
  };
  EXPECT_NE(entry({}).find("'command' is empty"), std::string::npos);
  EXPECT_NE(entry({{"true"}, "", {}, "txt"}, "my rival").find("a name consists of"), std::string::npos);
  EXPECT_NE(entry({{"true", "{point}"}, "", {}, "txt"}).find("unknown placeholder {point}"), std::string::npos);
  EXPECT_NE(entry({{"true"}, "", {{"A", "{kk}"}}, "txt"}).find("unknown placeholder {kk}"), std::string::npos);
  EXPECT_NE(entry({{"true"}, "", {}, "png"}).find("unknown format"), std::string::npos);
  EXPECT_NE(entry({{"true", "{edges}{triangles}"}, "", {}, "txt"}).find("both"), std::string::npos);
  EXPECT_EQ(entry({{"awk", "{print $1}", "{k}"}, "", {}, "txt"}), "none") << "other braces stay";
  const auto start = [](ExternalCommand command) {
    return mistake([&] { static_cast<void>(run(algorithm_of("rival", command, {}))); });
  };
  EXPECT_NE(start({{"no-such-program"}, "", {}, "txt"}).find("no such program in PATH"), std::string::npos);
  EXPECT_NE(start({{"./no-such"}, "/tmp", {}, "txt"}).find("/tmp/./no-such: is no program"), std::string::npos);
  EXPECT_NE(start({{"true"}, "/no/such/folder", {}, "txt"}).find("cannot be started in the folder"), std::string::npos);
}

TEST(ExternalCommands, AreIdentifiedByWhatTheyAre) {
  const TestFolder folder;
  write_text(folder.path("rival.sh"), "1");
  const ExternalCommand command{{"sh", "rival.sh"}, folder.path(""), {}, "txt"};
  const std::string before = content_hash_of(command);
  EXPECT_EQ(content_hash_of(command), before);
  write_text(folder.path("rival.sh"), "2");
  EXPECT_NE(content_hash_of(command), before);
}

}  // namespace
}  // namespace mwt
