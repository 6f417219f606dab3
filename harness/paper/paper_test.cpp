#include "harness/paper/paper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "base/error.h"
#include "base/number_text.h"
#include "generators/random.h"
#include "harness/io/input_file.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/paper/paper_tables.h"

namespace mwt {
namespace {

RunRecord run_of(const std::string& algorithm, std::uint64_t seed, double gap, double time = 1, Index n = 100) {
  RunRecord run;
  run.study = "s";
  run.run_id = algorithm + '/' + std::to_string(n) + '/' + std::to_string(seed);
  run.algorithm = algorithm;
  run.generator = "uniform";
  run.n = n;
  run.seed = seed;
  run.instance_id = std::to_string(n) + '/' + std::to_string(seed);
  run.status = RunStatus::ok;
  run.wall_time_s = time;
  run.weight_lower = run.weight_upper = 1 + gap;
  run.optimum_lower = run.optimum_upper = 1;
  run.alpha_lower = run.alpha_upper = 1 + gap;
  run.optimality = "proved";
  run.optimal = gap == 0 ? "yes" : "no";
  run.stopped_early = false;
  return run;
}

RunRecord failed(RunRecord run, RunStatus status) {
  run.status = status;
  run.wall_time_s.reset();
  run.alpha_lower.reset();
  run.alpha_upper.reset();
  run.optimality.clear();
  run.optimal.clear();
  return run;
}

ReportData report_of(std::vector<RunRecord> runs) {
  std::vector<Cell> cells = cells_of(runs);
  std::vector<CellSummary> summaries = summarise(cells);
  std::vector<SeriesGrowth> growth = growth_of(cells);
  Labels labels(cells);
  StudyRecords records;
  records.runs = std::move(runs);
  return {"folder", std::move(records), {}, std::move(cells), std::move(summaries), std::move(growth), {}, labels};
}

PaperData data_of(const std::vector<RunRecord>& runs, const PaperSelection& selection = {}) {
  return select_for_paper(report_of(runs), selection);
}

// Gaps of 30 instances, between 1% and 3%.
std::vector<double> thirty_gaps() {
  RandomEngine engine = make_engine("paper_test", 1);
  std::vector<double> gaps;
  for (int i = 0; i < 30; ++i) gaps.push_back(0.01 + 0.02 * uniform_unit(engine));
  return gaps;
}

std::set<std::string> bold_rows(const PaperTable& table) {
  std::set<std::string> rows;
  for (const std::vector<std::string>& row : table.latex.rows) {
    for (const std::string& cell : row) {
      if (cell.find("\\textbf") != std::string::npos) rows.insert(row.front());
    }
  }
  return rows;
}

TEST(PaperTables, APlantedTieIsNotBold) {
  std::vector<RunRecord> runs;
  const std::vector<double> gaps = thirty_gaps();
  for (std::uint64_t seed = 0; seed < gaps.size(); ++seed) {
    runs.push_back(run_of("sweep", seed, 2 * gaps[seed]));
    runs.push_back(run_of("greedy", seed, gaps[seed]));
    runs.push_back(run_of("greedy_naive", seed, gaps[seed]));
  }
  const PaperTable table = quality_table(data_of(runs), {"uniform"});
  EXPECT_TRUE(bold_rows(table).empty());
}

// Which is better changes from instance to instance, though the mean differs.
TEST(PaperTables, ADifferenceWithinTheNoiseIsNotBold) {
  std::vector<RunRecord> runs;
  const std::vector<double> gaps = thirty_gaps();
  for (std::uint64_t seed = 0; seed < gaps.size(); ++seed) {
    runs.push_back(run_of("greedy", seed, gaps[seed]));
    runs.push_back(run_of("flip", seed, gaps[gaps.size() - 1 - seed] * 0.99));
  }
  EXPECT_TRUE(bold_rows(quality_table(data_of(runs), {"uniform"})).empty());
}

TEST(PaperTables, APlantedDifferenceOfOnePercentOfTheGapIsBold) {
  std::vector<RunRecord> runs;
  const std::vector<double> gaps = thirty_gaps();
  for (std::uint64_t seed = 0; seed < gaps.size(); ++seed) {
    runs.push_back(run_of("greedy", seed, gaps[seed]));
    runs.push_back(run_of("flip", seed, 0.99 * gaps[seed]));
    runs.push_back(run_of("sweep", seed, 3 * gaps[seed]));
  }
  const PaperTable table = quality_table(data_of(runs), {"uniform"});
  EXPECT_EQ(bold_rows(table), (std::set<std::string>{"\\quad flip"}));
  ASSERT_EQ(table.csv.size(), 4u);
  for (const CsvRow& row : table.csv) EXPECT_EQ(row.size(), table.csv.front().size());
}

TEST(PaperTables, TimesFollowTheSameRule) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const double load = 1 + 0.1 * static_cast<double>(seed);
    runs.push_back(run_of("greedy", seed, 0.01, load));
    runs.push_back(run_of("flip", seed, 0.01, 1.01 * load));
  }
  const ReportData report = report_of(runs);
  const PaperTable table = time_table(report, select_for_paper(report, {}), {"uniform"});
  EXPECT_EQ(bold_rows(table), (std::set<std::string>{"\\quad greedy"}));
}

TEST(PaperTables, FailuresCountAsWorstAndAreStated) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    runs.push_back(run_of("greedy", seed, 0.02));
    const RunRecord flip = run_of("flip", seed, 0.01);
    runs.push_back(seed < 20 ? failed(flip, RunStatus::timeout) : flip);
  }
  const PaperTable table = quality_table(data_of(runs), {"uniform"});
  EXPECT_FALSE(bold_rows(table).contains("\\quad flip"));
  EXPECT_EQ(table.csv[2][3], "20");
  const CsvRows pairs = pair_rows(data_of(runs), PaperMeasure::gap);
  EXPECT_EQ(pairs[1][3], "20") << "greedy is better where flip failed";
  EXPECT_EQ(pairs[1][5], "10");
}

TEST(PaperData, ComparesOnTheSameInstancesOnly) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    runs.push_back(run_of("greedy", seed, 0.02));
    runs.push_back(run_of("flip", seed, 0.01));
    if (seed < 2) runs.push_back(run_of("brute_force", seed, 0));
  }
  const PaperData data = data_of(runs);
  EXPECT_EQ(data.algorithms, (std::vector<std::string>{"greedy", "flip"})) << "2 * 20 is more than 3 * 2";
  EXPECT_EQ(data.left_out, (std::vector<std::string>{"brute_force"}));
  EXPECT_EQ(data.common(PaperMeasure::gap).size(), 20u);
  EXPECT_EQ(data_of(runs, {{}, {}, {"flip", "brute_force"}}).common(PaperMeasure::gap).size(), 2u);
}

TEST(PaperData, NamesWhatTheStudyHas) {
  const ReportData report = report_of({run_of("greedy", 1, 0.02), run_of("flip", 1, 0.02)});
  for (const PaperSelection& selection :
       {PaperSelection{{"grid"}, {}, {}}, PaperSelection{{}, {7}, {}}, PaperSelection{{}, {}, {"patch"}}}) {
    EXPECT_THROW((void)select_for_paper(report, selection), InputError);
  }
  EXPECT_THROW((void)select_for_paper(report_of({run_of("greedy", 1, 0.02), run_of("flip", 2, 0.02)}),
                                      {{}, {}, {"greedy", "flip"}}),
               InputError)
      << "no instance in common";
}

TEST(PaperData, IntervalsThatOverlapAreEqual) {
  RunRecord wide = run_of("greedy", 1, 0.02);
  wide.alpha_lower = 1.005;
  const PaperData data = data_of({wide, run_of("flip", 1, 0.01), run_of("sweep", 1, 0.03)});
  const auto position = [&](const std::string& label) {
    return static_cast<std::size_t>(std::ranges::find(data.algorithms, label) - data.algorithms.begin());
  };
  EXPECT_EQ(data.difference(PaperMeasure::gap, position("greedy"), position("flip"), 0), 0);
  EXPECT_GT(data.difference(PaperMeasure::gap, position("greedy"), position("sweep"), 0), 0);
}

TEST(PaperCurves, StepsOfKnownAnswers) {
  std::vector<RunRecord> runs = {run_of("greedy", 1, 0, 1), run_of("greedy", 2, 0.5, 4), run_of("flip", 1, 1, 2),
                                 failed(run_of("flip", 2, 0), RunStatus::crashed)};
  const PaperData data = data_of(runs, {{}, {}, {"greedy", "flip"}});
  EXPECT_EQ(profile_rows(data, PaperMeasure::gap),
            (CsvRows{{"label", "ratio", "share"}, {"greedy", "0", "1"}, {"flip", "1", "0.5"}}));
  EXPECT_EQ(profile_rows(data, PaperMeasure::time),
            (CsvRows{{"label", "ratio", "share"}, {"greedy", "1", "1"}, {"flip", "2", "0.5"}}));
  EXPECT_EQ(
      distribution_rows(data, PaperMeasure::gap),
      (CsvRows{{"label", "value", "share"}, {"greedy", "0", "0.5"}, {"greedy", "0.5", "1"}, {"flip", "1", "0.5"}}));
}

TEST(PaperCurves, ParetoFront) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    runs.push_back(run_of("sweep", seed, 0.5, 1));
    runs.push_back(run_of("greedy", seed, 0.1, 2));
    runs.push_back(run_of("flip", seed, 0.2, 3));  // worse than greedy in both
  }
  std::map<std::string, std::string> is_pareto;
  for (const CsvRow& row : trade_off_rows(data_of(runs))) is_pareto[row[1]] = row.back();
  EXPECT_EQ(is_pareto["sweep"], "1");
  EXPECT_EQ(is_pareto["greedy"], "1");
  EXPECT_EQ(is_pareto["flip"], "0");
}

TEST(Latex, TextAndNumbers) {
  EXPECT_EQ(latex_text("a_b 50% & {c}#1"), "a\\_\\allowbreak{}b 50\\% \\& \\{c\\}\\#1");
  EXPECT_EQ(latex_number(0), "0");
  EXPECT_EQ(latex_number(0.0123456), "0.0123");
  EXPECT_EQ(latex_number(123.456), "123");
  EXPECT_EQ(latex_number(9.996), "10.0");
  EXPECT_EQ(latex_number(45678), "45700");
  EXPECT_EQ(latex_number(1.234e-7), "$1.23\\cdot10^{-7}$");
  EXPECT_EQ(latex_number(-2.5e9, 2), "$-2.5\\cdot10^{9}$");
}

TEST(Paper, WritesWhatTheStudyHasAndRemovesTheRest) {
  const test::TestFolder folder;
  std::vector<RunRecord> runs;
  for (const Index n : {100u, 200u, 400u}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      runs.push_back(run_of("greedy", seed, 0.01 + 0.001 * static_cast<double>(seed), 1e-6 * n, n));
      runs.push_back(run_of("flip", seed, 0.02, 2e-6 * n, n));
    }
  }
  const std::string out = folder.path("out");
  EXPECT_FALSE(write_paper(report_of(runs), {}, out, "mwt report folder --paper out").empty());
  for (const char* name : {"tables/quality.tex", "tables/time.csv", "tables/growth.tex", "data/pairs_gap.csv",
                           "data/profile_time.csv", "data/growth_lines.csv", "data/outcomes.csv", "README.md"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::path(out) / name)) << name;
  }
  EXPECT_NE(read_file(out + "/README.md").find("mwt report folder --paper out"), std::string::npos);

  for (RunRecord& run : runs) {  // no optimum, one size
    run.optimality = "none";
    run.alpha_lower.reset();
    run.alpha_upper.reset();
  }
  std::erase_if(runs, [](const RunRecord& run) { return run.n != 100; });
  (void)write_paper(report_of(runs), {}, out, "again");
  for (const char* name : {"tables/quality.tex", "tables/growth.tex", "data/pairs_gap.csv", "data/growth_lines.csv"})
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(out) / name)) << name;
  EXPECT_EQ(read_file(out + "/figures.tex").find("tables/quality"), std::string::npos);
  EXPECT_NE(read_file(out + "/figures.tex").find("tables/time"), std::string::npos);
}

}  // namespace
}  // namespace mwt
