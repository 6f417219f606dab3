#include "harness/report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "geometry/error.h"
#include "harness/folder_testing.h"
#include "harness/report/failures.h"
#include "harness/report/final_rating.h"
#include "harness/report/summary_files.h"
#include "harness/report/tables.h"

namespace mwt {
namespace {

RunRecord ok_run(const std::string& algorithm, Index n, std::uint64_t seed, double time, double alpha) {
  RunRecord run;
  run.study = "s";
  run.algorithm = algorithm;
  run.generator = "uniform";
  run.n = n;
  run.seed = seed;
  run.instance_id = std::to_string(n) + '/' + std::to_string(seed);
  run.status = RunStatus::ok;
  run.wall_time_s = time;
  run.weight_lower = run.weight_upper = alpha;
  run.optimum_lower = run.optimum_upper = 1;
  run.alpha_lower = run.alpha_upper = alpha;
  run.optimality = "proved";
  run.optimal = alpha == 1 ? "yes" : "no";
  return run;
}

RunRecord failed_run(const std::string& algorithm, RunStatus status) {
  RunRecord run;
  run.algorithm = algorithm;
  run.generator = "uniform";
  run.n = 10;
  run.status = status;
  return run;
}

TEST(Cells, CountAndGroupRuns) {
  std::vector<RunRecord> runs = {ok_run("sweep", 10, 1, 1, 2), ok_run("delaunay", 10, 1, 1, 1),
                                 ok_run("sweep", 5, 1, 1, 2), failed_run("sweep", RunStatus::timeout),
                                 failed_run("sweep", RunStatus::not_applicable)};
  runs[0].generator = "grid";
  const std::vector<Cell> cells = cells_of(runs);
  ASSERT_EQ(cells.size(), 4u);
  EXPECT_EQ(cells[0].key.generator, "grid") << "families in the order of their first run";
  EXPECT_EQ(cells[1].key.algorithm, "delaunay") << "algorithms in the order of the registry";
  EXPECT_EQ(cells[2].key.n, 5u) << "sizes ascending";
  EXPECT_EQ(cells[3].runs, 1u);
  EXPECT_EQ(cells[3].failures, 1u);
  EXPECT_EQ(cells[3].not_applicable, 1u);
  EXPECT_EQ(cells[3].instances, 0u);
}

TEST(Cells, RepetitionsAreNoFurtherObservations) {
  const std::vector<Cell> two_instances = cells_of({ok_run("sweep", 10, 1, 1, 2), ok_run("sweep", 10, 1, 3, 2),
                                                    ok_run("sweep", 10, 1, 8, 2), ok_run("sweep", 10, 2, 5, 1)});
  EXPECT_EQ(two_instances[0].times, (std::vector<double>{3, 5}));
  EXPECT_EQ(two_instances[0].alphas, (std::vector<double>{2, 1}));
  EXPECT_EQ(two_instances[0].optimal, 1u);
  EXPECT_EQ(two_instances[0].largest_alpha, 2);
  const std::vector<Cell> one_instance = cells_of({ok_run("sweep", 10, 1, 1, 2), ok_run("sweep", 10, 1, 3, 2)});
  EXPECT_EQ(one_instance[0].times, (std::vector<double>{1, 3})) << "nothing else tells the noise";
  EXPECT_EQ(one_instance[0].alphas.size(), 1u);
}

TEST(Cells, OnlyProvedOptimaRate) {
  RunRecord bounded = ok_run("sweep", 10, 1, 1, 2);
  bounded.optimality = "bounded";
  const std::vector<Cell> cells = cells_of({bounded});
  EXPECT_TRUE(cells[0].alphas.empty());
  EXPECT_EQ(cells[0].times.size(), 1u);
}

TEST(CellSummary, KnownAnswers) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 1; seed <= 21; ++seed) {
    const double step = static_cast<double>(seed - 1);
    runs.push_back(ok_run("sweep", 10, seed, step + 1, 1 + step / 20));
  }
  const CellSummary summary = summarise(cells_of(runs)[0]);
  EXPECT_EQ(summary.time->estimate.value, 11);
  EXPECT_TRUE(summary.time->has_interval);
  EXPECT_LT(summary.time->estimate.lower, 11);
  EXPECT_GT(summary.time->estimate.upper, 11);
  EXPECT_NEAR(summary.alpha_mean->estimate.value, 1.5, 1e-12);
  EXPECT_NEAR(summary.alpha_median->estimate.value, 1.5, 1e-12);
  EXPECT_NEAR(summary.alpha_p95->estimate.value, 1.95, 1e-12);
  EXPECT_EQ(summary.cell.largest_alpha, 2);
  EXPECT_NEAR(*summary.optimal_share, 1.0 / 21, 1e-12);
  EXPECT_GT(summary.optimal_range->upper, 0.2);
  EXPECT_FALSE(summary.yardsticks);
}

TEST(CellSummary, FewObservationsHaveNoInterval) {
  const CellSummary summary = summarise(cells_of({ok_run("sweep", 10, 1, 1, 2), ok_run("sweep", 10, 2, 3, 2)})[0]);
  EXPECT_EQ(summary.time->estimate.value, 2);
  EXPECT_FALSE(summary.time->has_interval);
}

TEST(CellSummary, TimesAreAlsoToldInYardsticks) {
  RunRecord run = ok_run("sweep", 10, 1, 6, 1);
  run.yardstick_time_s = 4;
  EXPECT_EQ(summarise(cells_of({run})[0]).yardsticks->estimate.value, 1.5);
}

std::vector<RunRecord> power_law_runs() {
  std::vector<RunRecord> runs;
  for (const Index n : {10u, 100u, 1000u, 10000u}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      runs.push_back(ok_run("sweep", n, seed, 3e-9 * std::pow(n, 1.5), 1));
      if (n <= 100) runs.push_back(ok_run("greedy", n, seed, 1, 1));
    }
  }
  return runs;
}

TEST(Growth, FindsTheExponents) {
  const std::vector<SeriesGrowth> growth = growth_of(cells_of(power_law_runs()));
  ASSERT_EQ(growth.size(), 1u) << "two sizes make no law";
  EXPECT_EQ(growth[0].series.algorithm, "sweep");
  EXPECT_NEAR(growth[0].time->law.exponent.value, 1.5, 1e-9);
  EXPECT_NEAR(growth[0].time->law.r_squared, 1, 1e-9);
  EXPECT_NEAR(std::exp(growth[0].time->law.log_factor.value), 3e-9, 1e-15);
  EXPECT_NEAR(growth[0].alpha->law.exponent.value, 0, 1e-12);
  EXPECT_EQ(growth[0].time->sizes, 4u);
  EXPECT_EQ(growth[0].time->observations, 20u);
  EXPECT_EQ(growth[0].time->largest_n, 10000u);
}

TEST(Tables, LookAsTheyShould) {
  std::vector<RunRecord> runs = {ok_run("sweep", 10, 1, 1e-3, 1), ok_run("sweep", 10, 2, 3e-3, 1.5),
                                 failed_run("sweep", RunStatus::timeout),
                                 failed_run("brute_force", RunStatus::not_applicable)};
  const std::vector<Cell> cells = cells_of(runs);
  const Labels labels(cells);
  EXPECT_EQ(
      algorithm_table(cells, labels),
      "alpha by algorithm, all families and sizes together (rated: instances with a proved optimum)\n"
      "algorithm    runs  failures  not applicable  rated instances  alpha mean   median      p95      max  optimal\n"
      "sweep           3         1               0                2     1.25000  1.25000  1.47500  1.50000      50%\n"
      "brute_force     0         0               1                0           -        -        -        -        -\n");
  EXPECT_EQ(cell_tables(summarise(cells), labels),
            "uniform\n"
            "  algorithm   n  runs  failed  median time  95%  alpha mean  95%   median      p95      max  optimal\n"
            "  sweep      10     3       1      2.00 ms    -     1.25000    -  1.25000  1.47500  1.50000      50%\n");
  EXPECT_EQ(growth_tables(growth_of(cells), labels), "");
  runs[0].yardstick_time_s = runs[1].yardstick_time_s = 1e-3;
  EXPECT_NE(cell_tables(summarise(cells_of(runs)), labels).find("50%               2.00\n"), std::string::npos);
}

TEST(Tables, AHundredPercentMeansAll) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) runs.push_back(ok_run("sweep", 10, seed, 1, seed == 1 ? 2 : 1));
  const std::vector<Cell> cells = cells_of(runs);
  EXPECT_NE(algorithm_table(cells, Labels(cells)).find(" 99%\n"), std::string::npos);
}

TEST(Tables, ExponentsHaveNoNegativeZeros) {
  std::vector<RunRecord> runs = power_law_runs();
  for (RunRecord& run : runs) run.alpha_upper = *run.alpha_upper + 1e-6 / run.n;
  const std::vector<Cell> cells = cells_of(runs);
  const std::string text = growth_tables(growth_of(cells), Labels(cells));
  EXPECT_NE(text.find("10 .. 10000     1.500  1.500 .. 1.500  1.000"), std::string::npos) << text;
  EXPECT_EQ(text.find("-0.000"), std::string::npos) << text;
}

TEST(Labels, ParametersAreNamedOnlyWhereTheyDiffer) {
  std::vector<RunRecord> runs = {ok_run("patch", 10, 1, 1, 1)};
  runs[0].params = "k=1";
  const CellKey first = cells_of(runs)[0].key;
  EXPECT_EQ(Labels(cells_of(runs)).algorithm(first), "patch");
  runs.push_back(runs[0]);
  runs[1].params = "k=2";
  EXPECT_EQ(Labels(cells_of(runs)).algorithm(first), "patch k=1");
}

TEST(Labels, FilesAreCalledByTheirNames) {
  RunRecord run = ok_run("patch", 52, 1, 1, 1);
  run.generator = "file";
  run.generator_params = "file=berlin52.tsp";
  const std::vector<Cell> cells = cells_of({run});
  EXPECT_EQ(Labels(cells).family(cells[0].key), "berlin52.tsp");
}

TEST(Labels, BlanksInNamesOfFilesAreShown) {
  RunRecord run = ok_run("patch", 52, 1, 1, 1);
  run.generator = "file";
  run.generator_params = "file=my%20points.txt";
  const std::vector<Cell> cells = cells_of({run});
  EXPECT_EQ(Labels(cells).family(cells[0].key), "my points.txt");
}

TEST(FinalRating, WhatWasProvedLaterCountsForAll) {
  StudyRecords records;
  records.runs = {ok_run("sweep", 10, 1, 1, 2), ok_run("exact", 10, 1, 1, 1)};
  records.runs[0].optimum_lower = 0.5;
  records.runs[0].optimum_upper = 2;
  records.runs[0].optimality = "bounded";
  records.runs[1].certified_lower = 1;
  const std::vector<RunRecord> rated = finally_rated(records);
  EXPECT_EQ(rated[0].optimality, "proved");
  EXPECT_EQ(rated[0].alpha_upper, 2);
  EXPECT_EQ(rated[0].optimal, "no");
  EXPECT_EQ(rated[1].optimal, "yes");
}

TEST(FinalRating, AClaimThatALighterTriangulationDisprovesIsTheError) {
  StudyRecords records;
  records.runs = {ok_run("sweep", 10, 1, 1, 2), ok_run("exact", 10, 1, 1, 1.5), ok_run("patch", 10, 1, 1, 1)};
  records.runs[1].certified_lower = 1.5;
  for (std::size_t i = 0; i < 3; ++i) records.runs[i].run_id = std::to_string(i);
  const std::vector<RunRecord> rated = finally_rated(records);
  EXPECT_EQ(rated[0].status, RunStatus::ok);
  EXPECT_FALSE(rated[0].alpha_upper);
  EXPECT_EQ(rated[1].status, RunStatus::error);
  EXPECT_EQ(rated[2].status, RunStatus::ok);
}

std::vector<std::string> documented_columns(const std::string& file) {
  std::vector<std::string> columns;
  std::istringstream page(testing::read_text(MWT_SOURCE_DIR "/results/README.md"));
  std::string section;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) section = line.substr(3);
    if (section == file && line.starts_with("| `")) columns.push_back(line.substr(3, line.find('`', 3) - 3));
  }
  return columns;
}

TEST(SummaryFiles, TheSchemaPageListsExactlyTheColumnsInTheirOrder) {
  EXPECT_EQ(parse_csv(summary_csv("s", {})).front(), documented_columns("summary.csv"));
  EXPECT_EQ(parse_csv(exponents_csv("s", {})).front(), documented_columns("exponents.csv"));
}

TEST(SummaryFiles, RowsHaveTheValues) {
  const std::vector<Cell> cells = cells_of(power_law_runs());
  const std::vector<CsvRow> rows = parse_csv(exponents_csv("s", growth_of(cells)));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1][4], "sweep");
  EXPECT_EQ(rows[1][6], "wall_time_s");
  EXPECT_EQ(rows[2][6], "alpha");
  EXPECT_EQ(parse_csv(summary_csv("s", summarise(cells))).size(), 7u);
}

TEST(Report, EveryPartWorksOnAStudysFolder) {
  const testing::TestFolder folder;
  StudyRecords records;
  records.runs = power_law_runs();
  write_records(folder.path("out"), records);
  const ReportData data = read_report_data(folder.path("out"));
  std::ostringstream tables, results;
  for (const ReportPart& part : report_tables()) part(data, tables);
  for (const ReportPart& part : report_results()) part(data, results);
  EXPECT_NE(tables.str().find("growth with n"), std::string::npos);
  EXPECT_NE(results.str().find("the source report's claims"), std::string::npos);
  EXPECT_EQ(parse_csv(testing::read_text(folder.path("out/summary.csv"))).size(), 7u);
  EXPECT_EQ(parse_csv(testing::read_text(folder.path("out/exponents.csv"))).size(), 3u);
}

TEST(Report, ManyFailuresAreFewLines) {
  std::vector<RunRecord> runs = power_law_runs();
  EXPECT_EQ(failure_table(runs), "");
  for (Index n : {30U, 20U}) {
    runs.push_back(failed_run("sweep", RunStatus::timeout));
    runs.back().n = n;
    runs.back().message = "too slow";
  }
  runs.push_back(failed_run("sweep", RunStatus::crashed));
  runs.push_back(failed_run("delaunay", RunStatus::timeout));
  runs.push_back(failed_run("flip", RunStatus::not_applicable));
  EXPECT_EQ(failure_table(runs),
            "failed    how      runs  first on             message\n"
            "sweep     timeout     2  uniform n=30 seed=0  too slow\n"
            "delaunay  timeout     1  uniform n=10 seed=0\n"
            "sweep     crashed     1  uniform n=10 seed=0\n");
}

TEST(Report, DifferentBugsAndParametersAreDifferentLines) {
  std::vector<RunRecord> runs;
  const auto add = [&](const std::string& params, const std::string& message) {
    runs.push_back(failed_run("patch", RunStatus::error));
    runs.back().params = params;
    runs.back().message = message;
  };
  add("k=4", "triangle 17 has no side");
  add("k=4", "triangle 3 has no side");
  add("k=4", "its code asks for a parameter 'q'");
  add("k=14", "triangle 5 has no side");
  EXPECT_EQ(failure_table(runs),
            "failed      how    runs  first on             message\n"
            "patch k=4   error     2  uniform n=10 seed=0  triangle 17 has no side\n"
            "patch k=14  error     1  uniform n=10 seed=0  triangle 5 has no side\n"
            "patch k=4   error     1  uniform n=10 seed=0  its code asks for a parameter 'q'\n");
}

TEST(Report, ThousandsOfKindsOfFailureAreCutShort) {
  std::vector<RunRecord> runs;
  for (int i = 0; i < 60; ++i) {
    runs.push_back(failed_run("patch", RunStatus::error));
    runs.back().message = std::string(static_cast<std::size_t>(i + 1), 'x');
  }
  EXPECT_TRUE(failure_table(runs).ends_with("10 more kinds of failure: see runs.csv\n"));
}

TEST(Report, WithoutRecordsItIsAMistake) {
  const testing::TestFolder folder;
  EXPECT_THROW(static_cast<void>(read_report_data(folder.path("missing"))), InputError);
  write_records(folder.path("empty"), {});
  EXPECT_THROW(static_cast<void>(read_report_data(folder.path("empty"))), InputError);
}

}  // namespace
}  // namespace mwt
