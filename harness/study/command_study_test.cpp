// Studies with programs of others among their algorithms.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

#include "harness/io/testing/folder_testing.h"
#include "harness/records/results_folder.h"
#include "harness/run/catalogue.h"
#include "harness/study/run_study.h"

namespace mwt {
namespace {

using testing::read_text;
using testing::TestFolder;
using testing::write_text;

// Twenty rows of each; {well} is a program that works.
constexpr const char* kPlanted = R"(name = "planted"
summary = "Programs that behave in every way"
families = ["uniform", "circle", "grid", "collinear_rows"]
sizes = [9, 16, 25, 36, 49]
seeds = [1]
min_time_s = 1e-4
algorithms = [
  "greedy",
  { name = "well", command = ["./fan_sweep.sh"], folder = "FOLDER" },
  { name = "exits", command = ["sh", "-c", "exit 3"] },
  { name = "babbles", command = ["sh", "-c", "echo all is well"] },
  { name = "hangs", command = ["sleep", "1000"] },
  { name = "leaves_a_child", command = ["sh", "-c", "setsid sleep 1000 & exec ./fan_sweep.sh"], folder = "FOLDER" },
  { name = "allocates", command = ["sh", "-c", "tail /dev/zero"] },
  { name = "lies", command = ["sh", "-c", "echo 0,1,2"] },
  { name = "complains", command = ["sh", "-c", "echo hello >&2"] },
  { name = "claims", command = ["sh", "-c", "./fan_sweep.sh; echo '{\"lower_bound\": 1e300}'"], folder = "FOLDER" },
]
[limits]
time_s = 2
grace_s = 0.5
memory_mb = 64
[optimum]
seek = false
)";

class ScopedVariable {
 public:
  ScopedVariable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~ScopedVariable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

Study study_in(const TestFolder& folder, std::string text) {
  const std::string examples = std::string(MWT_SOURCE_DIR) + "/library/examples/rivals";
  for (std::size_t at = text.find("FOLDER"); at != std::string::npos; at = text.find("FOLDER"))
    text.replace(at, 6, examples);
  write_text(folder.path("study.toml"), text);
  return read_study(folder.path("study.toml"));
}

std::string run_to(const Study& study, const std::string& out, bool resume = false) {
  std::ostringstream text;
  static_cast<void>(run_study(study, Catalogue::built_in(), {out, resume, 1, false}, text));
  return text.str();
}

TEST(CommandStudySlow, EveryKindOfProgramHasItsRows) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path("tmp"));
  const ScopedVariable temporary("TMPDIR", folder.path("tmp"));
  run_to(study_in(folder, kPlanted), folder.path("out"));
  std::map<std::string, std::map<std::string, int>> statuses;
  for (const RunRecord& run : read_runs(folder.path("out"))) ++statuses[run.algorithm][to_text(run.status)];
  const std::map<std::string, std::string> expected = {{"greedy", "ok"},
                                                       {"well", "ok"},
                                                       {"exits", "error"},
                                                       {"babbles", "invalid_output"},
                                                       {"hangs", "timeout"},
                                                       {"leaves_a_child", "ok"},
                                                       {"lies", "invalid_output"},
                                                       {"complains", "invalid_output"},
                                                       {"allocates", "out_of_memory"},
                                                       {"claims", "error"}};
  ASSERT_EQ(statuses.size(), expected.size());
  for (const auto& [algorithm, status] : expected)
    EXPECT_EQ(statuses[algorithm], (std::map<std::string, int>{{status, 20}})) << algorithm;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("tmp")))
    EXPECT_FALSE(entry.path().filename().string().starts_with("mwt-command-")) << entry.path();
}

constexpr const char* kRivals = R"(name = "r"
summary = "t"
families = ["uniform"]
sizes = [40]
seeds = [1, 2]
algorithms = [
  { name = "in_python", command = ["./delaunay_flips.py", "{points}", "{triangles}"], folder = "FOLDER" },
  { name = "in_c", command = ["./fan_sweep.sh"], folder = "FOLDER" },
  { name = "by_adapter", command = ["./json_edges_adapter.py", "{points}", "{edges}", "./json_stub.py"], folder = "FOLDER" },
  { name = "own", command = ["sh", "own.sh", "{kind}"], parameters = { kind = ["one", "two"] } },
]
)";

TEST(CommandStudy, ExamplesWork) {
  const TestFolder folder;
  write_text(folder.path("own.sh"), "exec " + std::string(MWT_SOURCE_DIR) + "/library/examples/rivals/fan_sweep.sh\n");
  const std::string printed = run_to(study_in(folder, kRivals), folder.path("out"));
  EXPECT_NE(printed.find("in_python: starting it takes "), std::string::npos) << printed;
  const std::vector<RunRecord> runs = read_runs(folder.path("out"));
  EXPECT_EQ(runs.size(), 10u);
  for (const RunRecord& run : runs) {
    ASSERT_EQ(run.status, RunStatus::ok) << run.algorithm << ": " << run.message;
    EXPECT_EQ(run.optimality, "proved");
    EXPECT_GT(named_number(run.counters, "start_time_s"), 0) << run.algorithm;
    EXPECT_EQ(run.iterations, 1u);
    EXPECT_EQ(run.claimed_lower.has_value(), run.algorithm == "by_adapter");
    EXPECT_FALSE(run.certified_lower);
    if (run.algorithm == "in_python") {
      EXPECT_LT(named_number(run.counters, "stated_time_s"), run.wall_time_s);
    }
  }
}

TEST(CommandStudy, AnEditedProgramRunsAgain) {
  const TestFolder folder;
  const std::string script = "exec " + std::string(MWT_SOURCE_DIR) + "/library/examples/rivals/fan_sweep.sh\n";
  const std::string text = R"(name = "r"
summary = "t"
families = ["uniform"]
sizes = [10]
algorithms = [{ name = "own", command = ["sh", "own.sh"] }]
[optimum]
seek = false
)";
  write_text(folder.path("own.sh"), script);
  EXPECT_NE(run_to(study_in(folder, text), folder.path("out")).find("starting it takes"), std::string::npos);
  const std::string resumed = run_to(study_in(folder, text), folder.path("out"), true);
  EXPECT_EQ(resumed.find("starting it takes"), std::string::npos) << "nothing is left to run";
  EXPECT_EQ(read_runs(folder.path("out")).size(), 1u);
  write_text(folder.path("own.sh"), "# changed\n" + script);
  EXPECT_THROW(run_to(study_in(folder, text), folder.path("out"), true), InputError)
      << "its runs are of another program";
}

TEST(CommandStudy, AClaimedBoundIsNoMoreThanThat) {
  const TestFolder folder;
  const Study study = study_in(folder, R"(name = "r"
summary = "t"
families = ["uniform"]
sizes = [10]
algorithms = [
  { name = "modest", command = ["sh", "-c", "./fan_sweep.sh; echo '{\"lower_bound\": 1}'"], folder = "FOLDER" },
  { name = "silent", command = ["./fan_sweep.sh"], folder = "FOLDER" },
]
[optimum]
seek = false
)");
  run_to(study, folder.path("out"));
  for (const RunRecord& run : read_runs(folder.path("out"))) {
    EXPECT_EQ(run.optimality, run.algorithm == "modest" ? "claimed" : "none");
    EXPECT_FALSE(run.alpha_upper);
  }
}

TEST(CommandStudy, MistakesNameTheirLine) {
  const TestFolder folder;
  const auto mistake = [&](const std::string& algorithm) {
    write_text(
        folder.path("s.toml"),
        "name = 's'\nsummary = 't'\nfamilies = ['uniform']\nsizes = [10]\nalgorithms = [\n" + algorithm + "\n]\n");
    try {
      static_cast<void>(read_study(folder.path("s.toml")));
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.substr(message.find("s.toml"));
    }
    return std::string("none");
  };
  EXPECT_EQ(mistake("{ name = 'greedy', command = ['true'] }"),
            "s.toml:6: greedy: an algorithm of mwt has this name; give your command another one");
  EXPECT_EQ(mistake("{ name = 'a', command = ['true'] }, { name = 'a', command = ['false'] }"),
            "s.toml:6: a: two commands have this name");
  EXPECT_NE(mistake("{ name = 'a', command = 'true' }").find("'command' must be a list"), std::string::npos);
  EXPECT_NE(mistake("{ name = 'a', command = ['true', '{x}'] }").find("s.toml:6: a: unknown placeholder {x}"),
            std::string::npos);
  EXPECT_NE(mistake("{ name = 'a', command = ['true'], environment = 3 }").find("must be a table"), std::string::npos);
}

}  // namespace
}  // namespace mwt
