// `mwt solve` and `mwt run` from end to end, with the real algorithms.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/study/results_folder.h"
#include "harness/test_support.h"

namespace mwt {
namespace {

using testing::read_text;
using testing::TemporaryFolder;
using testing::write_text;

class Solve : public ::testing::Test {
 protected:
  [[nodiscard]] int mwt(const std::string& arguments) const {
    const std::string command = "cd " + folder_.path("") + " && MWT_CACHE_DIR=optima " MWT_EXECUTABLE " " + arguments +
                                " >" + folder_.path(".out") + " 2>" + folder_.path(".err");
    return WEXITSTATUS(std::system(command.c_str()));
  }
  [[nodiscard]] nlohmann::json output() const { return nlohmann::json::parse(read_text(folder_.path(".out"))); }

  TemporaryFolder folder_;
};

TEST_F(Solve, JsonHasExactlyTheDocumentedFields) {
  write_text(folder_.path("p.txt"), "0 0\n2 0\n2 2\n0 2\n1 1\n2 0\n");
  ASSERT_EQ(mwt("solve p.txt --algorithm delaunay --json"), 0);
  const nlohmann::json report = output();
  const std::vector<std::string> fields = {
      "algorithm",     "parameters",    "seed",          "threads",        "n",
      "distinct",      "duplicates",    "hull_size",     "triangles",      "edges",
      "weight_lower",  "weight_upper",  "perimeter_sum", "count",          "stopped_early",
      "optimum_lower", "optimum_upper", "optimality",    "alpha_lower",    "alpha_upper",
      "valid",         "wall_time_s",   "cpu_time_s",    "peak_rss_bytes", "phases",
      "counters",      "optimum_cached"};
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
  const double weight = 8 + 4 * std::sqrt(2.0);
  EXPECT_NEAR(report["weight_lower"].get<double>(), weight, 1e-12);
  EXPECT_LE(report["weight_lower"].get<double>(), report["weight_upper"].get<double>());
}

TEST_F(Solve, TheReportsExampleAgainstItsProvedOptimum) {
  ASSERT_EQ(mwt("generate report_example -o p.txt"), 0);
  ASSERT_EQ(mwt("solve p.txt --algorithm hull_insertion --with-optimum --json"), 0);
  const nlohmann::json report = output();
  EXPECT_EQ(report["optimality"], "proved");
  EXPECT_NEAR(report["optimum_upper"].get<double>(), 70.9585925243, 1e-9);
  EXPECT_NEAR(report["alpha_lower"].get<double>(), 1.21965, 1e-5);
}

TEST_F(Solve, TheOptimumIsSoughtOnceAndThenCached) {
  ASSERT_EQ(mwt("generate uniform --n 50 -o p.txt"), 0);
  const std::string command = "solve p.txt --algorithm greedy --with-optimum --json";
  ASSERT_EQ(mwt(command + " --no-cache"), 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("optima")));
  ASSERT_EQ(mwt(command), 0);
  const nlohmann::json first = output();
  ASSERT_EQ(mwt(command), 0);
  const nlohmann::json second = output();
  EXPECT_FALSE(first["optimum_cached"]);
  EXPECT_TRUE(second["optimum_cached"]);
  EXPECT_EQ(second["optimality"], "proved");
  for (const char* field : {"optimum_lower", "optimum_upper", "alpha_lower", "alpha_upper"})
    EXPECT_EQ(second[field], first[field]) << field;
  ASSERT_EQ(mwt(command + " --no-cache"), 0);
  EXPECT_FALSE(output()["optimum_cached"]);
}

TEST_F(Solve, AnOptimumThatTheAlgorithmProvedIsNotSoughtAgain) {
  ASSERT_EQ(mwt("generate uniform --n 50 -o p.txt"), 0);
  ASSERT_EQ(mwt("solve p.txt --algorithm triangle_lp --with-optimum --json"), 0);
  EXPECT_EQ(output()["optimality"], "proved");
  EXPECT_FALSE(output()["optimum_cached"]);
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path("optima"))) {
    EXPECT_NE(entry.path().string().find("-triangle_lp-"), std::string::npos) << "no other solver was asked";
  }
  ASSERT_EQ(mwt("solve p.txt --algorithm delaunay --with-optimum --json"), 0);
  EXPECT_TRUE(output()["optimum_cached"]) << "and now it is known";
}

TEST_F(Solve, AnUnusableCacheIsAWarningOnly) {
  write_text(folder_.path("optima"), "a file where the folder should be");
  write_text(folder_.path("p.txt"), "0 0\n2 0\n2 2\n0 2\n1 1\n");
  ASSERT_EQ(mwt("solve p.txt --algorithm delaunay --with-optimum --json"), 0);
  EXPECT_EQ(output()["optimality"], "proved");
  const std::string errors = read_text(folder_.path(".err"));
  EXPECT_TRUE(errors.starts_with("mwt: warning: optima are not cached: ")) << errors;
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
}

TEST_F(Solve, WritesTrianglesEdgesAndAPicture) {
  write_text(folder_.path("p.txt"), "0 0\n0 0\n2 0\n2 2\n0 2\n1 1\n");
  ASSERT_EQ(mwt("solve p.txt --algorithm delaunay --triangles t.csv --edges e.csv --svg t.svg"), 0);
  EXPECT_EQ(mwt("check p.txt t.csv"), 0) << "corners refer to the input, duplicates counted";
  EXPECT_NE(read_text(folder_.path("e.csv")).find("0,2"), std::string::npos);
  EXPECT_NE(read_text(folder_.path("t.svg")).find("<svg"), std::string::npos);
}

TEST_F(Solve, StartsFromAGivenTriangulation) {
  write_text(folder_.path("p.txt"), "0 0\n4 0\n5 1\n0 1\n");
  write_text(folder_.path("start.csv"), "0,1,2\n0,2,3\n");
  write_text(folder_.path("broken.csv"), "0,1,2\n");
  ASSERT_EQ(mwt("solve p.txt --algorithm flip_report --param start=start.csv --json"), 0);
  EXPECT_EQ(output()["parameters"]["start"], "start.csv");
  EXPECT_EQ(mwt("solve p.txt --algorithm flip_report --param start=broken.csv"), 2);
  EXPECT_NE(read_text(folder_.path(".err")).find("broken.csv: not a triangulation"), std::string::npos);
  EXPECT_EQ(mwt("solve p.txt --algorithm flip_report --param start=missing.csv"), 2);
}

TEST_F(Solve, AnInstanceTheAlgorithmDoesNotTakeIsAMistake) {
  ASSERT_EQ(mwt("generate uniform --n 60 -o p.txt"), 0);
  EXPECT_EQ(mwt("solve p.txt --algorithm brute_force"), 2);
  EXPECT_TRUE(read_text(folder_.path(".err")).starts_with("mwt: ")) << read_text(folder_.path(".err"));
}

TEST_F(Solve, AStudyRunsAndResumes) {
  write_text(folder_.path("tiny.toml"), R"(name = "tiny"
summary = "two algorithms on two families"
families = ["uniform", "grid"]
sizes = [8]
algorithms = ["delaunay", "greedy_report"]
min_time_s = 0.001
)");
  ASSERT_EQ(mwt("run tiny.toml"), 0) << read_text(folder_.path(".err"));
  EXPECT_NE(read_text(folder_.path(".out")).find("alpha by algorithm"), std::string::npos);
  const std::vector<RunRecord> runs = read_runs(folder_.path("results/tiny"));
  ASSERT_EQ(runs.size(), 4u);
  for (const RunRecord& run : runs) EXPECT_EQ(run.optimality, "proved") << run.algorithm << ' ' << run.generator;
  EXPECT_EQ(mwt("run tiny.toml"), 2);
  EXPECT_NE(read_text(folder_.path(".err")).find("--resume"), std::string::npos);
  EXPECT_EQ(mwt("run tiny.toml --resume --jobs 2"), 0);
  EXPECT_EQ(read_runs(folder_.path("results/tiny")).size(), 4u);
  ASSERT_EQ(mwt("run tiny.toml --out again"), 0);
  const std::string instances = read_text(folder_.path("again/instances.csv"));
  EXPECT_NE(instances.find(",cached\n"), std::string::npos) << instances;
  ASSERT_EQ(mwt("run tiny.toml --out anew --no-cache"), 0);
  EXPECT_EQ(read_text(folder_.path("anew/instances.csv")).find("cached"), std::string::npos);
}

}  // namespace
}  // namespace mwt
