// `mwt solve` and `mwt run` from end to end, with the real algorithms.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/cli/testing/commands_testing.h"
#include "harness/io/points/point_file.h"
#include "harness/rating/optimum_cache.h"
#include "harness/rating/optimum_search.h"
#include "harness/records/results_folder.h"

namespace mwt {
namespace {

using testing::CommandResult;

class Solve : public testing::CommandTest {
 protected:
  [[nodiscard]] nlohmann::json json_of(const std::string& arguments) const {
    return nlohmann::json::parse(run(arguments + " --json"));
  }
};

TEST_F(Solve, JsonHasExactlyTheDocumentedFields) {
  write("p.txt", "0 0\n2 0\n2 2\n0 2\n1 1\n2 0\n");
  const nlohmann::json report = json_of("solve p.txt --algorithm delaunay");
  const std::vector<std::string> fields = {
      "algorithm",     "parameters",     "seed",          "threads",        "n",
      "distinct",      "duplicates",     "hull_size",     "triangles",      "edges",
      "weight_lower",  "weight_upper",   "perimeter_sum", "count",          "stopped_early",
      "optimum_lower", "optimum_upper",  "optimality",    "alpha_lower",    "alpha_upper",
      "valid",         "wall_time_s",    "cpu_time_s",    "peak_rss_bytes", "phases",
      "counters",      "optimum_cached", "stop_reason"};
  EXPECT_EQ(report.size(), fields.size());
  for (const std::string& field : fields) EXPECT_TRUE(report.contains(field)) << field;
  EXPECT_EQ(report["n"], 6);
  EXPECT_EQ(report["distinct"], 5);
  EXPECT_EQ(report["duplicates"], 1);
  EXPECT_EQ(report["triangles"], 4);
  EXPECT_EQ(report["edges"], 8);
  EXPECT_TRUE(report["valid"]);
  EXPECT_TRUE(report["alpha_upper"].is_null());
  EXPECT_EQ(report["optimality"], "none");
  EXPECT_FALSE(report["stopped_early"]);
  EXPECT_TRUE(report["stop_reason"].is_null());
  const double weight = 8 + 4 * std::sqrt(2.0);
  EXPECT_NEAR(report["weight_lower"].get<double>(), weight, 1e-12);
  EXPECT_LE(report["weight_lower"].get<double>(), report["weight_upper"].get<double>());
}

TEST_F(Solve, TheReportsExampleAgainstItsProvedOptimum) {
  run("generate report_example -o p.txt");
  const nlohmann::json report = json_of("solve p.txt --algorithm hull_insertion --with-optimum");
  EXPECT_EQ(report["optimality"], "proved");
  EXPECT_NEAR(report["optimum_upper"].get<double>(), 70.9585925243, 1e-9);
  EXPECT_NEAR(report["alpha_lower"].get<double>(), 1.21965, 1e-5);
}

TEST_F(Solve, TheOptimumIsSoughtOnceAndThenCached) {
  run("generate uniform --n 50 -o p.txt");
  const std::string command = "solve p.txt --algorithm greedy --with-optimum";
  run(command + " --no-cache");
  EXPECT_FALSE(exists("optima"));
  const nlohmann::json first = json_of(command);
  const nlohmann::json second = json_of(command);
  EXPECT_FALSE(first["optimum_cached"]);
  EXPECT_TRUE(second["optimum_cached"]);
  EXPECT_EQ(second["optimality"], "proved");
  for (const char* field : {"optimum_lower", "optimum_upper", "alpha_lower", "alpha_upper"})
    EXPECT_EQ(second[field], first[field]) << field;
  EXPECT_FALSE(json_of(command + " --no-cache")["optimum_cached"]);
}

TEST_F(Solve, AnOptimumThatTheAlgorithmProvedIsNotSoughtAgain) {
  run("generate uniform --n 50 -o p.txt");
  const nlohmann::json proved = json_of("solve p.txt --algorithm triangle_lp --with-optimum");
  EXPECT_EQ(proved["optimality"], "proved");
  EXPECT_FALSE(proved["optimum_cached"]);
  for (const auto& entry : std::filesystem::directory_iterator(path("optima"))) {
    EXPECT_NE(entry.path().string().find("-triangle_lp-"), std::string::npos) << "no other solver ran";
  }
  EXPECT_TRUE(json_of("solve p.txt --algorithm delaunay --with-optimum")["optimum_cached"]) << "and now it is known";
}

TEST_F(Solve, AnUnusableCacheIsAWarningOnly) {
  write("optima", "a file where the folder should be");
  write("p.txt", "0 0\n2 0\n2 2\n0 2\n1 1\n");
  const testing::CommandResult result = mwt("solve p.txt --algorithm delaunay --with-optimum --json");
  ASSERT_EQ(result.exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(result.output)["optimality"], "proved");
  const std::string& errors = result.errors;
  EXPECT_TRUE(errors.starts_with("mwt: warning: optima are not cached: ")) << errors;
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
}

TEST_F(Solve, WritesTrianglesEdgesAndAPicture) {
  write("p.txt", "0 0\n0 0\n2 0\n2 2\n0 2\n1 1\n");
  run("solve p.txt --algorithm delaunay --triangles t.csv --edges e.csv --svg t.svg");
  EXPECT_EQ(mwt("check p.txt t.csv").exit_code, 0) << "corners refer to the input, duplicates counted";
  EXPECT_NE(read("e.csv").find("0,2"), std::string::npos);
  EXPECT_NE(read("t.svg").find("<svg"), std::string::npos);
}

TEST_F(Solve, AFileOnStandardOutputComesAlone) {
  write("p.txt", "0 0\n2 0\n2 2\n0 2\n");
  run("solve p.txt --algorithm delaunay --triangles t.csv");
  const testing::CommandResult result = mwt("solve p.txt --algorithm delaunay --triangles -");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, read("t.csv"));
  EXPECT_TRUE(result.errors.starts_with("algorithm")) << result.errors;
  expect_mistake("solve p.txt --algorithm delaunay --json --edges -", "--json and --edges both go to standard output");
  expect_mistake("solve p.txt --algorithm delaunay --svg - --triangles /dev/stdout", "both go to standard output");
}

TEST_F(Solve, OutputsOverwriteNeitherInputsNorEachOther) {
  const std::string points = "0 0\n4 0\n5 1\n0 1\n", start = "0,1,2\n0,2,3\n";
  write("p.txt", points);
  write("s.csv", start);
  std::filesystem::create_symlink("p.txt", path("link.txt"));
  const std::string solve = "solve p.txt --algorithm flip --param start=s.csv ";
  expect_mistake(solve + "--triangles p.txt", "--triangles p.txt would overwrite the input (p.txt); give another name");
  expect_mistake(solve + "--triangles link.txt", "would overwrite the input (p.txt)");
  expect_mistake(solve + "--edges ./s.csv", "--edges ./s.csv would overwrite the input (s.csv)");
  expect_mistake(solve + "--triangles t.csv --edges ./t.csv", "--triangles and --edges both name ./t.csv");
  EXPECT_EQ(shell(MWT_EXECUTABLE " solve - --algorithm delaunay --triangles p.txt <p.txt 2>.err"), 2);
  EXPECT_NE(read(".err").find("would overwrite the input (standard input)"), std::string::npos) << read(".err");
  EXPECT_EQ(read("p.txt"), points);
  EXPECT_EQ(read("s.csv"), start);
  EXPECT_FALSE(exists("t.csv"));
  run(solve + "--triangles /dev/null --edges /dev/null");
}

TEST_F(Solve, OutputsThatCannotBeWrittenAreNamedBeforeTheWork) {
  run("generate uniform --n 1000000 -o p.txt");
  const auto refused = [&](const std::string& output, const std::string& part) {
    expect_mistake("solve p.txt --algorithm flip --param order=best " + output, part);
  };
  refused("--triangles no/t.csv", "no/t.csv: cannot be written: its folder does not exist");
  refused("--triangles .", ".: cannot be written: it is a folder");
  refused("--triangles ''", "the output file has an empty name");
  refused("--svg o.png", "o.png: a picture is written as SVG");
  refused("--edges o.json", "o.json: triangles and edges are written as CSV; give it a name that ends in .csv");
}

TEST_F(Solve, StartsFromAGivenTriangulation) {
  write("p.txt", "0 0\n4 0\n5 1\n0 1\n");
  write("start.csv", "0,1,2\n0,2,3\n");
  write("broken.csv", "0,1,2\n");
  const std::string flip = "solve p.txt --algorithm flip_naive --param start=";
  EXPECT_EQ(json_of(flip + "start.csv")["parameters"]["start"], "start.csv");
  expect_mistake(flip + "broken.csv", "broken.csv: not a triangulation");
  expect_mistake(flip + "missing.csv", "missing.csv");
}

TEST_F(Solve, AnInstanceTheAlgorithmDoesNotTakeIsAMistake) {
  run("generate uniform --n 60 -o p.txt");
  expect_mistake("solve p.txt --algorithm brute_force", "brute_force");
}

TEST_F(Solve, AStudyRunsAndResumes) {
  write("tiny.toml", R"(name = "tiny"
summary = "two algorithms on two families"
families = ["uniform", "grid"]
sizes = [8]
algorithms = ["delaunay", "greedy_naive"]
min_time_s = 0.001
)");
  EXPECT_NE(run("run tiny.toml").find("alpha by algorithm"), std::string::npos);
  const std::vector<RunRecord> runs = read_runs(path("results/tiny"));
  ASSERT_EQ(runs.size(), 4u);
  for (const RunRecord& run : runs) EXPECT_EQ(run.optimality, "proved") << run.algorithm << ' ' << run.generator;
  expect_mistake("run tiny.toml", "--resume");
  EXPECT_EQ(run("run tiny.toml --resume --jobs 2 --quiet").find("alpha by algorithm"), std::string::npos);
  EXPECT_EQ(read_runs(path("results/tiny")).size(), 4u);
  run("run tiny.toml --out again");
  const std::string instances = read("again/instances.csv");
  EXPECT_NE(instances.find(",cached,"), std::string::npos) << instances;
  run("run tiny.toml --out anew --no-cache");
  EXPECT_EQ(read("anew/instances.csv").find("cached"), std::string::npos);
}

TEST_F(Solve, AFailedRunIsShownEvenWhenQuiet) {
  write("start.csv", "0,1,2\n");
  write("broken.toml", R"(name = "broken"
summary = "begins with what is no triangulation"
families = ["uniform"]
sizes = [8]
algorithms = [{ name = "flip_naive", parameters = { start = "start.csv" } }]
)");
  for (const char* command : {"run broken.toml --quiet", "run broken.toml --quiet --resume"}) {
    const CommandResult result = mwt(command);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.output.find("start=start.csv  error     1  uniform n=8 seed=1  no start: "), std::string::npos)
        << result.output;
    EXPECT_NE(result.output.find("1 of 1 runs failed"), std::string::npos);
  }
}

// Entries of the optimum cache that pass every check and are wrong.
class SolveWithWrongCache : public Solve {
 protected:
  SolveWithWrongCache() {
    run("generate uniform --n 20 -o p.txt");
    const AlgorithmInfo& exact = Catalogue::built_in().algorithm("exact");
    const std::string id = make_instance(read_points(path("p.txt")), "p.txt").id;
    key_ = optimum_key(id, exact, Parameters(exact.name, exact.parameters, {}));
  }

  void store(double factor) {
    const double right = json_of("solve p.txt --algorithm exact --no-cache")["weight_upper"];
    cache_.store(key_, {{factor * right, factor * right}, 1});
  }

  [[nodiscard]] double cached_upper() {
    const std::optional<CachedOptimum> entry = cache_.find(key_);
    return entry ? entry->interval.upper : 0;
  }

  OptimumCache cache_{path("optima"), [](const std::string&) {}};
  OptimumKey key_;
};

TEST_F(SolveWithWrongCache, ALighterTriangulationThrowsTheEntryOut) {
  for (const char* algorithm : {"greedy", "exact"}) {
    store(1.5);
    const CommandResult result = mwt(std::string("solve p.txt --with-optimum --json --algorithm ") + algorithm);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.errors.find("CONTRADICTION: exact (optimum cache) certified"), std::string::npos) << result.errors;
    const nlohmann::json report = nlohmann::json::parse(result.output);
    EXPECT_EQ(report["optimality"], "proved");
    EXPECT_FALSE(report["optimum_cached"]);
    EXPECT_EQ(cached_upper(), report["optimum_upper"].get<double>()) << algorithm;
    EXPECT_EQ(mwt(std::string("solve p.txt --with-optimum --algorithm ") + algorithm).errors, "");
  }
}

TEST_F(SolveWithWrongCache, AnEntryBelowWhatASolverCertifiesIsAFailure) {
  store(0.5);
  const CommandResult result = mwt("solve p.txt --with-optimum --json --algorithm exact");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.errors.find("mwt: internal failure: CONTRADICTION: exact certified"), std::string::npos)
      << result.errors;
  EXPECT_TRUE(nlohmann::json::parse(result.output)["valid"]) << "the triangulation is good all the same";
}

TEST_F(Solve, AReportsTablesGoToAFileWhenAsked) {
  write("tiny.toml",
        "name = \"tiny\"\nsummary = \"x\"\nfamilies = [\"uniform\"]\nsizes = [8]\n"
        "algorithms = [\"delaunay\"]\nmin_time_s = 0.001\n");
  run("run tiny.toml --out records");
  const std::string everything = run("report records");
  const std::string verdicts = run("report records --tables tables.txt");
  EXPECT_TRUE(verdicts.starts_with("written: tables.txt\n")) << verdicts;
  EXPECT_EQ(read("tables.txt") + verdicts.substr(verdicts.find('\n') + 1), everything);
  const std::string rows = read("records/runs.csv");
  expect_mistake("report records --tables records/runs.csv", "would overwrite the input (records/runs.csv)");
  EXPECT_EQ(read("records/runs.csv"), rows);
}

}  // namespace
}  // namespace mwt
