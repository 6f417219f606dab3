#include "harness/study/run_study.h"

#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <map>
#include <sstream>

#include "algorithms/sweep/sweep.h"
#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/rating/optimum_cache.h"
#include "harness/records/results_folder.h"
#include "harness/run/testing/algorithms_testing.h"

namespace mwt {
namespace {

using testing::read_text;
using testing::TestFolder;
using testing::write_text;

Study study_of(const std::vector<std::string>& algorithms, const std::string& family = "uniform") {
  Study study;
  study.name = "s";
  study.file_content = "# s\n";
  study.families = {{family, {}, {}, {}, ""}};
  study.sizes = {10};
  study.min_time_s = 1e-4;
  study.limits = {0.3, 0.2, std::uint64_t{1} << 27};
  study.optimum_limits = study.limits;
  study.seeks_optimum = false;
  for (const std::string& name : algorithms) study.algorithms.push_back({name, {}, {}, ""});
  return study;
}

StudyOutcome run(const Study& study, const std::string& folder, bool resume = false, int jobs = 1) {
  std::ostringstream out;
  return run_study(study, testing::test_catalogue(), {folder, resume, jobs, false}, out);
}

std::map<std::string, RunRecord> by_algorithm(const std::string& folder) {
  std::map<std::string, RunRecord> records;
  for (const RunRecord& record : read_runs(folder)) records[record.algorithm] = record;
  return records;
}

TEST(RunStudy, EveryMisbehaviourIsOneRow) {
  const TestFolder folder;
  Study study = study_of({"crashes", "well", "leaves", "hangs", "allocates", "invalid", "throws", "declines", "chats",
                          "small", "claims", "loops", "well", "grumbles", "misspells"});
  study.limits.time_s = 2;  // so that a busy machine lets everything but "hangs" and "loops" come to its end
  const StudyOutcome outcome = run(study, folder.path("out"), false, 2);
  auto runs = by_algorithm(folder.path("out"));
  ASSERT_EQ(runs.size(), 14u);
  EXPECT_EQ(runs["well"].status, RunStatus::ok);
  EXPECT_EQ(runs["chats"].status, RunStatus::ok);
  EXPECT_EQ(runs["crashes"].status, RunStatus::crashed);
  EXPECT_EQ(runs["leaves"].status, RunStatus::crashed);
  EXPECT_TRUE(runs["leaves"].message.ends_with("; standard error: giving up")) << runs["leaves"].message;
  EXPECT_EQ(runs["hangs"].status, RunStatus::timeout);
  EXPECT_EQ(runs["loops"].status, RunStatus::timeout);
  const RunStatus when_refused = testing::kUsualAllocator ? RunStatus::out_of_memory : RunStatus::crashed;
  EXPECT_EQ(runs["allocates"].status, when_refused) << runs["allocates"].message;
  EXPECT_EQ(runs["invalid"].status, RunStatus::invalid_output);
  EXPECT_NE(runs["invalid"].checker, "ok");
  EXPECT_FALSE(runs["invalid"].wall_time_s) << "a failed run has no measures";
  EXPECT_EQ(runs["throws"].status, RunStatus::error);
  EXPECT_EQ(runs["throws"].message, "lost its way");
  EXPECT_EQ(runs["declines"].status, RunStatus::not_applicable);
  EXPECT_EQ(runs["small"].status, RunStatus::not_applicable);
  EXPECT_EQ(runs["claims"].status, RunStatus::error);
  EXPECT_TRUE(runs["claims"].message.starts_with("CONTRADICTION: claims certified")) << runs["claims"].message;
  EXPECT_EQ(runs["grumbles"].message, "an undeclared parameter; standard error: on standard error");
  EXPECT_EQ(runs["misspells"].message,
            "the code of 'misspells' reads a parameter 'kk' that its entry does not declare; it declares k, start");
  EXPECT_EQ(outcome.runs, 14u);
  EXPECT_EQ(outcome.failures, 10u);
}

TEST(RunStudy, RowsOfGoodRunsAreComplete) {
  const TestFolder folder;
  run(study_of({"well"}), folder.path("out"));
  const RunRecord record = by_algorithm(folder.path("out")).at("well");
  EXPECT_EQ(record.checker, "ok");
  EXPECT_EQ(record.optimality, "none");
  EXPECT_EQ(record.optimal, "undecided");
  EXPECT_FALSE(record.alpha_upper);
  EXPECT_GT(record.wall_time_s.value(), 0);
  EXPECT_GT(record.weight_lower.value(), 0);
  EXPECT_LE(record.weight_lower.value(), record.weight_upper.value());
  EXPECT_GT(record.triangles.value(), 0u);
  EXPECT_EQ(record.instance_id.size(), 32u);
  EXPECT_EQ(record.binary_sha256.size(), 64u);
}

Solution spin_for_100_us(Points points, Context& context) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(100);
  while (std::chrono::steady_clock::now() < end) {
  }
  return testing::solve_well(points, context);
}

// On a busy machine runs wait for the CPU, but hardly all of forty in more than half of their executions, and none uses
// more CPU time than there was.
TEST(RunStudy, CpuTimesOfShortRunsAreNotQuantised) {
  const TestFolder folder;
  const std::vector<AlgorithmInfo> algorithms = {testing::entry("spins", spin_for_100_us)};
  Study study = study_of({"spins"});
  study.min_time_s = 0.002;
  study.repetitions = 40;
  std::ostringstream out;
  static_cast<void>(run_study(study, Catalogue(algorithms, generators()), {folder.path("out")}, out));
  double max_share = 0;
  for (const RunRecord& record : read_runs(folder.path("out"))) {
    const double share = record.cpu_time_s.value() / record.wall_time_s.value();
    EXPECT_LT(share, 1.05);
    max_share = std::max(max_share, share);
  }
  EXPECT_GT(max_share, 0.95);
}

TEST(RunStudy, TheDelaunayTimeIsMeasuredWhereAStudySaysSo) {
  const TestFolder folder;
  Study study = study_of({"well", "throws"});
  run(study, folder.path("without"));
  EXPECT_FALSE(by_algorithm(folder.path("without")).at("well").delaunay_time_s);
  study.measures_delaunay_time = true;
  run(study, folder.path("with"));
  EXPECT_GT(by_algorithm(folder.path("with")).at("well").delaunay_time_s.value_or(0), 0);
  EXPECT_FALSE(by_algorithm(folder.path("with")).at("throws").delaunay_time_s);
}

TEST(RunStudy, AShardMayBeEmpty) {
  const TestFolder folder;
  std::ostringstream out;
  RunOptions options{folder.path("out")};
  options.shard = {3, 3};
  EXPECT_EQ(run_study(study_of({"well"}), testing::test_catalogue(), options, out).runs, 0u);
  EXPECT_TRUE(read_runs(folder.path("out")).empty());
}

TEST(RunStudy, AlphaComesFromTheOptimumSources) {
  const TestFolder folder;
  Study study = study_of({"well"}, "fan");
  study.seeks_optimum = true;
  study.optimum_sources = {{"weak_bound", {}, ""}, {"fan_exact", {}, ""}};
  run(study, folder.path("out"));
  const RunRecord record = by_algorithm(folder.path("out")).at("well");
  EXPECT_EQ(record.optimality, "proved");
  EXPECT_EQ(record.optimal, "yes");
  EXPECT_EQ(record.alpha_lower, 1);
  EXPECT_LT(record.alpha_upper.value(), 1 + 1e-12);
  EXPECT_NE(read_text(folder.path("out/instances.csv")).find(",weak_bound+fan_exact,"), std::string::npos);
}

TEST(RunStudy, BoundsThatProveNothingStillGiveAlpha) {
  const TestFolder folder;
  Study study = study_of({"well"});
  study.seeks_optimum = true;
  study.optimum_sources = {{"weak_bound", {}, ""}};
  run(study, folder.path("out"));
  const RunRecord record = by_algorithm(folder.path("out")).at("well");
  EXPECT_EQ(record.optimality, "bounded");
  EXPECT_NEAR(record.alpha_upper.value(), 2, 1e-9);
}

// Counts its calls in a file, for it is called in other processes.
std::string call_log;

Solution solve_fan_and_tell(Points points, Context& context) {
  std::ofstream(call_log, std::ios::app) << 'x';
  return testing::solve_fan_exactly(points, context);
}

TEST(RunStudy, AnotherStudySearchesNoOptimumAgain) {
  const TestFolder folder;
  call_log = folder.path("calls");
  const std::vector<AlgorithmInfo> algorithms = {testing::entry("well", testing::solve_well),
                                                 testing::entry("telling", solve_fan_and_tell, Exactness::exact)};
  const Catalogue catalogue(algorithms, generators());
  Study study = study_of({"well"}, "fan");
  study.sizes = {10, 20};
  study.seeks_optimum = true;
  const auto run_into = [&](const std::string& name, const std::optional<std::string>& cache) {
    std::ostringstream out;
    static_cast<void>(run_study(study, catalogue, {folder.path(name), false, 1, false, cache}, out));
    for (const RunRecord& record : read_runs(folder.path(name))) EXPECT_EQ(record.optimality, "proved") << name;
    return read_text(call_log);
  };
  EXPECT_EQ(run_into("first", folder.path("optima")), "xx");
  study.name = "another";
  EXPECT_EQ(run_into("second", folder.path("optima")), "xx");
  EXPECT_EQ(run_into("third", std::nullopt), "xxxx") << "without a cache";
}

TEST(RunStudy, OptimaThatRunsProveAreRemembered) {
  const TestFolder folder;
  Study study = study_of({"fan_exact", "weak_bound", "well"}, "fan");
  const auto run_into = [&](const std::string& name) {
    std::ostringstream out;
    return run_study(study, testing::test_catalogue(), {folder.path(name), false, 1, false, folder.path("optima")},
                     out);
  };
  EXPECT_EQ(run_into("first").failures, 0u);
  study.seeks_optimum = true;
  study.optimum_sources = {{"fan_exact", {}, ""}};
  EXPECT_EQ(run_into("second").failures, 0u);
  EXPECT_NE(read_text(folder.path("second/instances.csv")).find(",cached,"), std::string::npos);
}

TEST(RunStudy, RefusesToContinueWhatAnotherBuildBegan) {
  const TestFolder folder;
  const Study study = study_of({"well", "chats"});
  run(study, folder.path("out"));
  StudyRecords records = read_records(folder.path("out"));
  for (RunRecord& record : records.runs) record.binary_sha256 = "another";
  write_records(folder.path("complete"), records);
  EXPECT_EQ(run(study, folder.path("complete"), true).runs, 0u) << "nothing is missing";
  records.runs.pop_back();
  write_records(folder.path("begun"), records);
  EXPECT_THROW(run(study, folder.path("begun"), true), InputError);
  std::ostringstream out;
  RunOptions options{folder.path("begun"), true};
  options.accepts_other_build = true;
  EXPECT_EQ(run_study(study, testing::test_catalogue(), options, out).runs, 1u);
}

std::size_t files_in(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

// An entry that passes every check and is wrong all the same: an earlier version of a solver erred. The runs became the
// errors, and the entry stayed.
TEST(RunStudy, ADisprovedCachedOptimumIsThrownOutAndSoughtAnew) {
  const TestFolder folder;
  Study study = study_of({"well", "fan_exact"}, "fan");
  study.seeks_optimum = true;
  study.optimum_sources = {{"fan_exact", {}, ""}};
  run(study, folder.path("out"));
  const RunRecord right = by_algorithm(folder.path("out")).at("well");
  OptimumCache cache(folder.path("optima"), [](const std::string&) {});
  const OptimumKey key{right.instance_id, "fan_exact", 1, ""};
  const double wrong = 2 * *right.weight_upper;
  for (const int version : {1, 7}) cache.store({right.instance_id, "fan_exact", version, ""}, {{wrong, wrong}, 1});
  std::ostringstream out;
  const StudyOutcome outcome =
      run_study(study, testing::test_catalogue(), {folder.path("again"), false, 1, false, folder.path("optima")}, out);
  EXPECT_EQ(outcome.contradictions, 1u) << out.str();
  EXPECT_NE(
      out.str().find("CONTRADICTION: fan_exact (optimum cache) certified that no triangulation weighs less than "),
      std::string::npos)
      << out.str();
  const StudyRecords records = read_records(folder.path("again"));
  for (const RunRecord& record : records.runs) {
    EXPECT_EQ(record.status, RunStatus::ok) << record.message;
    EXPECT_EQ(record.optimal, "yes");
  }
  ASSERT_EQ(records.instances.size(), 1u);
  EXPECT_EQ(records.instances[0].optimality, "proved");
  EXPECT_EQ(records.instances[0].optimum_note, kCachedNote) << "by then a run had proved it";
  EXPECT_EQ(cache.find(key)->interval.upper, *right.weight_upper);
  EXPECT_EQ(files_in(folder.path("optima")), 1u) << "the other version's entry is disproved, too";
}

TEST(RunStudy, CachedOptimaThatExcludeEachOtherAreSoughtAnew) {
  const TestFolder folder;
  Study study = study_of({"well"}, "fan");
  study.seeks_optimum = true;
  study.optimum_sources = {{"fan_exact", {}, ""}, {"weak_bound", {}, ""}};
  run(study, folder.path("out"));
  const RunRecord right = by_algorithm(folder.path("out")).at("well");
  OptimumCache cache(folder.path("optima"), [](const std::string&) {});
  const OptimumKey good{right.instance_id, "fan_exact", 1, ""};
  const OptimumKey bad{right.instance_id, "weak_bound", 1, ""};
  cache.store(good, {{*right.weight_upper, *right.weight_upper}, 1});
  cache.store(bad, {{2 * *right.weight_upper, 2 * *right.weight_upper}, 1});
  std::ostringstream out;
  const StudyOutcome outcome =
      run_study(study, testing::test_catalogue(), {folder.path("again"), false, 1, false, folder.path("optima")}, out);
  EXPECT_EQ(outcome.contradictions, 0u);
  EXPECT_NE(out.str().find("; the optimum is sought anew"), std::string::npos) << out.str();
  const StudyRecords records = read_records(folder.path("again"));
  EXPECT_EQ(records.instances[0].optimality, "proved");
  EXPECT_EQ(records.instances[0].optimum_note, "") << "not from the cache";
  EXPECT_TRUE(cache.find(good));
  EXPECT_FALSE(cache.find(bad));
}

// A solver that claims too much: as "exact" did on flat points.
Solution certify_too_much(Points points, Context&) {
  Solution solution;
  solution.triangulation = sweep_triangulation(points);
  const Interval own = weight(points, solution.triangulation);
  solution.optimum = own;
  return solution;
}

class WrongSolver : public ::testing::Test {
 protected:
  WrongSolver() {
    // Its sweep triangulation is heavier than Delaunay's.
    study_.sizes = {30};
    study_.seeks_optimum = true;
    study_.optimum_sources = {{"wrong", {}, ""}};
  }

  StudyOutcome run_into(const std::string& name, bool resume = false) {
    out_.str("");
    RunOptions options{folder_.path(name), resume, 1, false, folder_.path("optima")};
    return run_study(study_, catalogue_, options, out_);
  }

  void expect_the_claimant_to_be_the_error(const std::string& name) {
    const StudyRecords records = read_records(folder_.path(name));
    for (const RunRecord& record : records.runs) {
      const bool is_claimant = record.algorithm == "wrong";
      EXPECT_EQ(record.status, is_claimant ? RunStatus::error : RunStatus::ok) << record.algorithm << record.message;
      EXPECT_EQ(record.message.starts_with("CONTRADICTION: wrong certified"), is_claimant);
      EXPECT_FALSE(record.alpha_upper);
      EXPECT_FALSE(record.optimum_lower);
    }
    ASSERT_EQ(records.instances.size(), 1u);
    EXPECT_EQ(records.instances[0].optimality, "none");
    EXPECT_TRUE(records.instances[0].optimum_note.starts_with("CONTRADICTION: wrong certified"));
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path("optima"))) ADD_FAILURE() << entry;
  }

  TestFolder folder_;
  std::vector<AlgorithmInfo> algorithms_ = {testing::entry("well", testing::solve_well),
                                            testing::entry("chats", testing::chat),
                                            testing::entry("wrong", certify_too_much, Exactness::exact)};
  Catalogue catalogue_{algorithms_, generators()};
  Study study_ = study_of({"well", "wrong", "chats"});
  std::ostringstream out_;
};

TEST_F(WrongSolver, IsTheErrorInRunsAndInstancesWhateverCameFirst) {
  study_.repetitions = 3;  // in several orders
  const StudyOutcome outcome = run_into("out");
  EXPECT_GE(outcome.contradictions, 4u) << "the source and three runs";
  EXPECT_EQ(outcome.runs, 9u);
  expect_the_claimant_to_be_the_error("out");
}

TEST_F(WrongSolver, IsTheErrorAfterAResumeToo) {
  static_cast<void>(run_into("out"));
  StudyRecords records = read_records(folder_.path("out"));
  for (RunRecord& record : records.runs) {
    if (record.algorithm != "wrong") continue;
    record.status = RunStatus::ok;  // as if the program had been killed before it replaced the row
    record.message.clear();
  }
  std::filesystem::remove_all(folder_.path("optima"));
  std::filesystem::create_directory(folder_.path("optima"));
  write_records(folder_.path("killed"), records);
  EXPECT_EQ(run_into("killed", true).runs, 0u);
  expect_the_claimant_to_be_the_error("killed");
}

TEST_F(WrongSolver, AnotherSourceIsAskedInstead) {
  study_.optimum_sources = {{"wrong", {}, ""}, {"weak_bound", {}, ""}};
  algorithms_.push_back(testing::entry("weak_bound", testing::solve_with_weak_bound, Exactness::exact));
  catalogue_ = Catalogue(algorithms_, generators());
  static_cast<void>(run_into("out"));
  const StudyRecords records = read_records(folder_.path("out"));
  EXPECT_EQ(records.instances[0].optimum_source, "weak_bound");
  EXPECT_EQ(records.instances[0].optimality, "bounded");
  EXPECT_TRUE(records.instances[0].optimum_note.starts_with("CONTRADICTION: wrong certified"))
      << records.instances[0].optimum_note;
  EXPECT_NE(records.instances[0].optimum_note.find("; wrong: bounds "), std::string::npos);
  EXPECT_NE(records.instances[0].optimum_note.find("; weak_bound: bounds "), std::string::npos);
  for (const RunRecord& record : records.runs) {
    EXPECT_EQ(record.alpha_upper.has_value(), record.status == RunStatus::ok) << record.algorithm;
  }
}

TEST_F(WrongSolver, ItsCachedClaimIsHeldAgainstItsRun) {
  study_.seeks_optimum = false;
  const Study honest = study_of({"well"});
  Study with_size = honest;
  with_size.sizes = {30};
  run(with_size, folder_.path("honest"));
  const RunRecord lighter = by_algorithm(folder_.path("honest")).at("well");
  OptimumCache cache(folder_.path("optima"), [](const std::string&) {});
  cache.store({lighter.instance_id, "wrong", 1, ""}, {{*lighter.weight_upper, *lighter.weight_upper}, 1});
  study_.algorithms = {{"wrong", {}, {}, ""}};
  EXPECT_EQ(run_into("out").contradictions, 1u);
  const RunRecord record = by_algorithm(folder_.path("out")).at("wrong");
  EXPECT_EQ(record.status, RunStatus::error);
  EXPECT_TRUE(record.message.ends_with(" weighs " + number_text(*lighter.weight_upper))) << record.message;
}

// What has to be the same however often a study was interrupted.
std::vector<std::string> essence(const std::string& folder) {
  std::vector<std::string> rows;
  for (const RunRecord& record : read_runs(folder)) {
    rows.push_back(record.run_id + ' ' + std::string(name_of(record.status)) + ' ' + record.optimal);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

TEST(RunStudy, ResumingRunsExactlyWhatIsMissing) {
  const TestFolder folder;
  Study study = study_of({"well", "throws", "chats"});
  study.seeds = {1, 2, 3};
  run(study, folder.path("out"));
  const std::string complete = read_text(folder.path("out/runs.csv"));
  const std::vector<std::string> expected = essence(folder.path("out"));
  for (const std::size_t kept : {complete.size() / 2, complete.size() / 3, std::size_t{20}, complete.size()}) {
    write_text(folder.path("out/runs.csv"), complete.substr(0, kept));
    run(study, folder.path("out"), true);
    EXPECT_EQ(essence(folder.path("out")), expected) << kept;
  }
}

std::string interrupt_log;

// Sends Ctrl-C to the study the first time.
Solution interrupt_once(Points points, Context& context) {
  if (!std::filesystem::exists(interrupt_log)) {
    write_text(interrupt_log, "x");
    kill(getppid(), SIGINT);
    return testing::hang(points, context);
  }
  return testing::solve_well(points, context);
}

TEST(RunStudy, CtrlCEndsItCleanlyAndResumeRunsTheRest) {
  const TestFolder folder;
  interrupt_log = folder.path("log");
  const std::vector<AlgorithmInfo> algorithms = {testing::entry("well", testing::solve_well),
                                                 testing::entry("interrupts", interrupt_once)};
  const Catalogue catalogue(algorithms, generators());
  Study study = study_of({"well", "interrupts"});
  study.repetitions = 3;
  std::ostringstream out;
  const StudyOutcome first = run_study(study, catalogue, {folder.path("out"), false, 1, false}, out);
  EXPECT_TRUE(first.interrupted);
  EXPECT_LT(first.runs, 6u);
  EXPECT_NE(out.str().find("interrupted; the same command with --resume"), std::string::npos) << out.str();
  EXPECT_EQ(read_runs(folder.path("out")).size(), first.runs) << "the run in flight is no row";
  const StudyOutcome second = run_study(study, catalogue, {folder.path("out"), true, 1, false}, out);
  EXPECT_FALSE(second.interrupted);
  EXPECT_EQ(first.runs + second.runs, 6u);
}

// What it lacks was added since.
TEST(RunStudy, AFolderOfAnEarlierBuildCanBeRead) {
  const TestFolder folder;
  run(study_of({"well", "small"}), folder.path("out"));
  const std::vector<RunRecord> runs = read_runs(folder.path("out"));
  for (const auto& [name, columns] :
       {std::pair("runs.csv", kFirstRunColumns), {"instances.csv", kFirstInstanceColumns}}) {
    std::string content;
    for (CsvRow row : parse_csv(read_text(folder.path(std::string("out/") + name)))) {
      row.resize(columns);
      content += csv_line(row);
    }
    write_text(folder.path(std::string("out/") + name), content);
  }
  const StudyRecords records = read_records(folder.path("out"));
  ASSERT_EQ(records.runs.size(), runs.size());
  EXPECT_EQ(records.runs[0].weight_upper, runs[0].weight_upper);
  EXPECT_FALSE(records.runs[0].claimed_lower);
  EXPECT_FALSE(records.instances.at(0).verified);
}

TEST(RunStudy, ResumingOnNothingBegins) {
  const TestFolder folder;
  EXPECT_EQ(run(study_of({"well"}), folder.path("a/b"), true).runs, 1u);
}

TEST(RunStudy, RefusesAFolderInUseOrOfAnotherStudy) {
  const TestFolder folder;
  Study study = study_of({"well"});
  run(study, folder.path("out"));
  const std::string before = read_text(folder.path("out/runs.csv"));
  EXPECT_THROW(run(study, folder.path("out")), InputError);
  study.file_content = "# another\n";
  EXPECT_THROW(run(study, folder.path("out"), true), InputError);
  write_text(folder.path("file"), "x");
  EXPECT_THROW(run(study, folder.path("file")), InputError);
  EXPECT_EQ(read_text(folder.path("file")), "x");
  study.file_content = "# s\n";
  {
    const ResultsFolder holder(folder.path("out"), study.name, study.file_content, true);
    EXPECT_THROW(run(study, folder.path("out"), true), InputError);
  }
  EXPECT_EQ(read_text(folder.path("out/runs.csv")), before);
}

std::string refusal(const Study& study, const std::string& folder) {
  return mwt::test::message_of<InputError>([&] { run(study, folder, true); });
}

class StudyOfFiles : public ::testing::Test {
 protected:
  StudyOfFiles() {
    write_text(folder_.path("a b.txt"), "0 0\n4 0\n5 1\n0 1\n");
    write_text(folder_.path("start.csv"), "0,1,2\n0,2,3\n");
    study_.families.clear();
    study_.folder = folder_.path("");
    study_.instance_files = {folder_.path(""), {"*.txt"}, "s.toml:1"};
    study_.algorithms = {{"well", {}, {}, ""}, {"tuned", {{"start", "start.csv"}}, {}, ""}};
    run(study_, folder_.path("out"));
    before_ = read_text(folder_.path("out/runs.csv"));
  }

  void expect_refusal(const std::string& part) {
    const std::string message = refusal(study_, folder_.path("out"));
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(read_text(folder_.path("out/runs.csv")), before_);
  }

  TestFolder folder_;
  Study study_ = study_of({});
  std::string before_;
};

// Two instances came under one name.
TEST_F(StudyOfFiles, AreNotResumedWithAnotherPointFile) {
  write_text(folder_.path("a b.txt"), "0 0\n4 0\n5 2\n0 1\n");
  expect_refusal("a b.txt: has changed since its runs were recorded in ");
  write_text(folder_.path("a b.txt"), "0 0\n4 0\n5 1\n0 1\n2 9\n");
  expect_refusal("a b.txt: has changed since its runs were recorded in ");
  write_text(folder_.path("c.txt"), "0 0\n4 0\n5 1\n0 1\n");
  std::filesystem::remove(folder_.path("a b.txt"));
  expect_refusal("is none of this study any more");
}

TEST_F(StudyOfFiles, AreNotResumedWithAnotherStart) {
  write_text(folder_.path("start.csv"), "1,2,0\n0,2,3\n");
  expect_refusal(
      "its run of tuned k=4 start=start.csv on file file=a%20b.txt n=4 seed=1 is none of this study any more");
}

// Only one of two names of the same points has a row in instances.csv.
TEST_F(StudyOfFiles, WithOnePointSetUnderTwoNamesAreCompleteWhenAllRunsAreRecorded) {
  write_text(folder_.path("c.txt"), "0 0\n4 0\n5 1\n0 1\n");
  EXPECT_EQ(run(study_, folder_.path("both")).runs, 4u);
  EXPECT_EQ(read_records(folder_.path("both")).instances.size(), 1u);
  std::ostringstream out;
  static_cast<void>(run_study(study_, testing::test_catalogue(), {folder_.path("both"), true, 1, false}, out));
  EXPECT_NE(out.str().find("steps 0/0, 0 failed"), std::string::npos) << out.str();
}

TEST_F(StudyOfFiles, AreResumedWhenNothingHasChanged) {
  EXPECT_EQ(run(study_, folder_.path("out"), true).runs, 0u);
  write_text(folder_.path("c.txt"), "0 0\n4 0\n5 1\n0 1\n");
  EXPECT_EQ(run(study_, folder_.path("out"), true).runs, 2u) << "a new file is more to run";
}

std::vector<Point> one_more_for_seed_2(Index n, std::uint64_t seed, const Parameters&) {
  std::vector<Point> points;
  for (Index i = 0; i < n + (seed == 2 ? 1 : 0); ++i) points.push_back({static_cast<double>(i), 1.0 * i * i});
  return points;
}

TEST(RunStudy, AFamilyThatReturnsTooManyPointsIsNamedInItsRows) {
  const TestFolder folder;
  GeneratorInfo family;
  family.name = "one_more";
  family.function = one_more_for_seed_2;
  const Catalogue catalogue(testing::test_catalogue().algorithms(), {&family, 1});
  Study study = study_of({"well"}, "one_more");
  study.seeds = {1, 2};
  std::ostringstream out;
  EXPECT_EQ(run_study(study, catalogue, {folder.path("out")}, out).failures, 1u);
  for (const RunRecord& record : read_runs(folder.path("out"))) {
    EXPECT_EQ(record.status, record.seed == 1 ? RunStatus::ok : RunStatus::error);
    if (record.seed != 2) continue;
    EXPECT_EQ(record.message,
              "no instance: generator one_more: returned 11 points for n=10 seed=2; its function is wrong");
  }
}

TEST(RunStudy, HalfWrittenFilesOfAllKindsAreMadeWhole) {
  const TestFolder folder;
  Study study = study_of({"well", "chats"});
  study.seeds = {1, 2};
  run(study, folder.path("whole"));
  const std::vector<std::string> expected = essence(folder.path("whole"));
  int round = 0;
  for (const char* name : {"runs.csv", "instances.csv", "environments.csv"}) {
    const std::string complete = read_text(folder.path(std::string("whole/") + name));
    for (const std::size_t kept : {std::size_t{0}, std::size_t{7}, complete.size() / 2, complete.size() - 1}) {
      const std::string out = folder.path(std::to_string(round++));
      std::filesystem::copy(folder.path("whole"), out);
      write_text(out + '/' + name, complete.substr(0, kept));
      run(study, out, true);
      EXPECT_EQ(essence(out), expected) << name << ' ' << kept;
    }
    const std::string out = folder.path(std::to_string(round++));
    std::filesystem::copy(folder.path("whole"), out);
    std::filesystem::remove(out + '/' + name);
    run(study, out, true);
    EXPECT_EQ(essence(out), expected) << name;
  }
}

TEST(RunStudy, WhatAKilledFirstWriteLeftIsNoHindrance) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path("out"));
  for (const char* empty : {"runs.csv", "instances.csv", "environments.csv"}) {
    write_text(folder.path("out/" + std::string(empty)), "");
  }
  write_text(folder.path("out/.mwt-123-0.tmp"), "name");
  EXPECT_EQ(run(study_of({"well"}), folder.path("out"), true).runs, 1u);
}

TEST(RunStudy, ResumesInNoFolderThatMayBeSomebodyElses) {
  const TestFolder folder;
  const Study study = study_of({"well"});
  std::filesystem::create_directory(folder.path("photos"));
  write_text(folder.path("photos/cat.jpg"), "x");
  EXPECT_NE(refusal(study, folder.path("photos")).find("no study.toml"), std::string::npos);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path("photos")), {}), 1);
  run(study, folder.path("out"));
  Study renamed = study;
  renamed.name = "another";
  EXPECT_NE(refusal(renamed, folder.path("out")).find("holds runs of the study 's'"), std::string::npos);
  const std::string rows = read_text(folder.path("out/runs.csv"));
  write_text(folder.path("out/runs.csv"), rows + rows.substr(rows.find('\n') + 1));
  EXPECT_NE(refusal(study, folder.path("out")).find("runs.csv:3: the run "), std::string::npos);
  std::filesystem::remove(folder.path("out/runs.csv"));
  ASSERT_EQ(mkfifo(folder.path("out/runs.csv").c_str(), 0600), 0);
  EXPECT_NE(refusal(study, folder.path("out")).find("runs.csv: records need a regular file"), std::string::npos);
}

// In this process every flock() fails with that error from now on.
void let_flock_fail(int error) {
  sock_filter program[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_flock, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | static_cast<unsigned>(error)),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog filter{4, program};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0) _exit(9);
}

// "another mwt run is writing here" was said of file systems without locks.
TEST(RunStudy, AFileSystemWithoutLocksIsCalledThat) {
  const TestFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    let_flock_fail(ENOLCK);
    const std::string message = refusal(study_of({"well"}), folder.path("out"));
    _exit(message.find("out: cannot be locked: No locks available; choose a folder on another file system") ==
                  std::string::npos
              ? 1
              : 7);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WEXITSTATUS(status) == 9) GTEST_SKIP() << "no system call can be made to fail here";
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(RunStudy, WrongSourcesAreRefusedBeforeTheFolderIsMade) {
  const TestFolder folder;
  Study study = study_of({"well"});
  study.optimum_sources = {{"well", {}, "s.toml:9"}};
  EXPECT_THROW(run(study, folder.path("out")), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder.path("out")));
}

}  // namespace
}  // namespace mwt
