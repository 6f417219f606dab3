#include "harness/report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "base/error.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/records/known_optima.h"
#include "harness/report/failures.h"
#include "harness/report/machines.h"
#include "harness/report/side_by_side.h"
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
  EXPECT_EQ(two_instances[0].max_alpha, 2);
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
  EXPECT_EQ(summary.cell.max_alpha, 2);
  EXPECT_NEAR(*summary.optimal_share, 1.0 / 21, 1e-12);
  EXPECT_GT(summary.optimal_range->upper, 0.2);
  EXPECT_FALSE(summary.over_delaunay);
}

TEST(CellSummary, FewObservationsHaveNoInterval) {
  const CellSummary summary = summarise(cells_of({ok_run("sweep", 10, 1, 1, 2), ok_run("sweep", 10, 2, 3, 2)})[0]);
  EXPECT_EQ(summary.time->estimate.value, 2);
  EXPECT_FALSE(summary.time->has_interval);
}

TEST(CellSummary, TimesAreAlsoGivenOverDelaunay) {
  RunRecord run = ok_run("sweep", 10, 1, 6, 1);
  run.delaunay_time_s = 4;
  EXPECT_EQ(summarise(cells_of({run})[0]).over_delaunay->estimate.value, 1.5);
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
  EXPECT_NEAR(growth[0].time->law.r_squared.value(), 1, 1e-9);
  EXPECT_NEAR(std::exp(growth[0].time->law.log_factor.value), 3e-9, 1e-15);
  EXPECT_NEAR(growth[0].alpha->law.exponent.value, 0, 1e-12);
  EXPECT_FALSE(growth[0].alpha->law.r_squared);
  EXPECT_EQ(growth[0].time->sizes, 4u);
  EXPECT_EQ(growth[0].time->observations, 20u);
  EXPECT_EQ(growth[0].time->max_n, 10000u);
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
  runs[0].delaunay_time_s = runs[1].delaunay_time_s = 1e-3;
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

TEST(Labels, TheUsualConfigurationKeepsTheBareName) {
  std::vector<RunRecord> runs(3, ok_run("flip", 10, 1, 1, 1));
  runs[0].params = runs[1].params = "order=a start=x";
  runs[2].params = "order=a start=y";
  const std::vector<Cell> cells = cells_of(runs);
  EXPECT_EQ(Labels(cells).algorithm(cells[0].key), "flip");
  EXPECT_EQ(Labels(cells).algorithm(cells[1].key), "flip start=y");
  const CsvRow row = parse_csv(summary_csv("s", summarise(cells), Labels(cells))).back();
  EXPECT_EQ((CsvRow{row.end() - 3, row.end() - 1}), (CsvRow{"flip start=y", "uniform"}));
}

TEST(Labels, EquallyUsualConfigurationsAllStateTheirParameters) {
  std::vector<RunRecord> runs(2, ok_run("patch", 10, 1, 1, 1));
  runs[0].params = "k=14 m=1";
  runs[1].params = "k=6 m=1";
  const std::vector<Cell> cells = cells_of(runs);
  EXPECT_EQ(Labels(cells).algorithm(cells[0].key), "patch k=14");
  EXPECT_EQ(Labels(cells).algorithm(cells[1].key), "patch k=6");
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
  const std::vector<RunRecord> rated = rated_by_all_bounds(records.runs, records.instances);
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
  const std::vector<RunRecord> rated = rated_by_all_bounds(records.runs, records.instances);
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
  EXPECT_EQ(parse_csv(summary_csv("s", {}, Labels({}))).front(), documented_columns("summary.csv"));
  EXPECT_EQ(parse_csv(exponents_csv("s", {}, Labels({}))).front(), documented_columns("exponents.csv"));
  EXPECT_EQ(parse_csv(ratings_csv("s", {})).front(), documented_columns("ratings.csv"));
  EXPECT_EQ(parse_csv(observations_csv("s", {}, Labels({}))).front(), documented_columns("observations.csv"));
  const SideBySide nothing{nullptr, nullptr, Labels({}), {}, {}, {}};
  EXPECT_EQ(parse_csv(side_by_side_cells_csv(nothing)).front(), documented_columns("cells.csv"));
}

TEST(SummaryFiles, RowsHaveTheValues) {
  const std::vector<Cell> cells = cells_of(power_law_runs());
  const std::vector<CsvRow> rows = parse_csv(exponents_csv("s", growth_of(cells), Labels(cells)));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1][4], "sweep");
  EXPECT_EQ(rows[1][6], "wall_time_s");
  EXPECT_EQ(rows[2][6], "alpha");
  EXPECT_EQ(parse_csv(summary_csv("s", summarise(cells), Labels(cells))).size(), 7u);
  std::vector<RunRecord> runs = {ok_run("sweep", 10, 1, 1, 1.25), failed_run("sweep", RunStatus::timeout)};
  runs.front().run_id = "r";
  const std::vector<CsvRow> ratings = parse_csv(ratings_csv("s", runs));
  ASSERT_EQ(ratings.size(), 2u) << "of runs that are ok";
  EXPECT_EQ((CsvRow{ratings[1].begin() + 2, ratings[1].end()}), (CsvRow{"r", "proved", "1.25", "1.25", "no", "1"}));
}

TEST(Observations, AreMediansOverTheRepetitionsOnAnInstance) {
  std::vector<RunRecord> runs = {ok_run("sweep", 10, 2, 5, 3), ok_run("sweep", 10, 1, 1, 2),
                                 ok_run("sweep", 10, 1, 3, 2), ok_run("sweep", 10, 1, 8, 2),
                                 failed_run("sweep", RunStatus::not_applicable)};
  runs[0].stopped_early = true;
  runs.push_back(failed_run("sweep", RunStatus::timeout));
  runs.back().seed = 1;
  const std::vector<Observation> observations = observations_of(runs);
  ASSERT_EQ(observations.size(), 2u);
  EXPECT_EQ(observations[0].seed, 1u);
  EXPECT_EQ(observations[0].runs, 4u);
  EXPECT_EQ(observations[0].failures, 1u);
  EXPECT_EQ(observations[0].time_s, 3);
  EXPECT_EQ(observations[0].alpha_upper, 2);
  EXPECT_EQ(observations[1].stopped_early, 1u);
  const std::vector<CsvRow> rows = parse_csv(observations_csv("s", observations, Labels(cells_of(runs))));
  EXPECT_EQ((CsvRow{rows.at(2).end() - 3, rows.at(2).end()}), (CsvRow{"3", "sweep", "uniform"}));
  EXPECT_EQ(parse_csv(summary_csv("s", summarise(cells_of(runs)), Labels(cells_of(runs)))).at(1).back(), "1");
}

TEST(Report, EveryPartWorksOnAStudysFolder) {
  const testing::TestFolder folder;
  StudyRecords records;
  records.runs = power_law_runs();
  records.study_file = "claims = true\n";
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

TEST(Report, ClaimsAreJudgedByStudiesMadeForThemOnly) {
  const testing::TestFolder folder;
  StudyRecords records;
  records.runs = power_law_runs();
  write_records(folder.path("out"), records);
  testing::write_text(folder.path("out/claims.csv"), "left by an earlier report\n");
  std::ostringstream results;
  for (const ReportPart& part : report_results()) part(read_report_data(folder.path("out")), results);
  EXPECT_EQ(results.str().find("claims"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.path("out/claims.csv")));
  EXPECT_TRUE(std::filesystem::exists(folder.path("out/ratings.csv")));
}

StudyRecords runs_of_two_machines() {
  StudyRecords records;
  records.runs = power_law_runs();
  for (const char* cpu : {"Abacus", "Difference Engine"}) {
    EnvironmentRecord environment;
    environment.env_id = environment.cpu_model = cpu;
    records.environments.push_back(environment);
  }
  for (RunRecord& run : records.runs) {
    run.env_id = run.seed == 1 ? "Abacus" : "Difference Engine";
    run.cpu_time_s = run.delaunay_time_s = run.wall_time_s;
  }
  return records;
}

// A shard that ran on another machine went into the same medians.
TEST(Report, TimesOfSeveralMachinesAreNotTakenTogether) {
  const testing::TestFolder folder;
  const StudyRecords records = runs_of_two_machines();
  const auto on_abacus = std::count_if(records.runs.begin(), records.runs.end(),
                                       [](const RunRecord& run) { return run.env_id == "Abacus"; });
  const auto others = static_cast<std::ptrdiff_t>(records.runs.size()) - on_abacus;
  ASSERT_TRUE(on_abacus > 0 && others > 0 && on_abacus != others);
  const std::string chosen = on_abacus > others ? "Abacus" : "Difference Engine";
  write_records(folder.path("out"), records);
  const ReportData data = read_report_data(folder.path("out"));
  for (const RunRecord& run : data.records.runs) {
    EXPECT_EQ(run.wall_time_s.has_value(), run.env_id == chosen);
    EXPECT_EQ(run.cpu_time_s.has_value(), run.env_id == chosen);
    EXPECT_EQ(run.delaunay_time_s.has_value(), run.env_id == chosen);
  }
  std::ostringstream tables, results;
  for (const ReportPart& part : report_tables()) part(data, tables);
  for (const ReportPart& part : report_results()) part(data, results);
  for (const std::string& text : {tables.str(), results.str()}) {
    EXPECT_TRUE(text.starts_with("warning: runs of 2 machines: Abacus (")) << text.substr(0, 200);
    EXPECT_NE(text.find("all times here are those of " + chosen + " alone"), std::string::npos);
  }
}

TEST(Report, RunsSideBySideAreNotComparedWithOthers) {
  StudyRecords records = runs_of_two_machines();
  for (EnvironmentRecord& environment : records.environments) environment.cpu_model = "Abacus";
  StudyRecords same = records;
  EXPECT_TRUE(keep_times_of_one_machine(same).empty());
  records.environments[1].jobs = 2;
  ASSERT_EQ(keep_times_of_one_machine(records).size(), 1u);
  EXPECT_NE(keep_times_of_one_machine(records).at(0).find("Abacus, 2 runs side by side"), std::string::npos);
}

TEST(Report, ABusyMachineIsTold) {
  StudyRecords records;
  records.runs = power_law_runs();
  for (RunRecord& run : records.runs) run.cpu_time_s = *run.wall_time_s;
  EXPECT_TRUE(keep_times_of_one_machine(records).empty());
  for (RunRecord& run : records.runs) *run.cpu_time_s /= 4;
  EXPECT_EQ(
      keep_times_of_one_machine(records),
      std::vector<std::string>{"the machine was busy with other programs: the runs had the CPU 25% of the time; wall "
                               "times are longer than on an idle one"});
}

TEST(Report, SeveralBuildsAreTold) {
  StudyRecords records;
  records.runs = power_law_runs();
  records.runs[0].git_commit = "abc";
  const std::vector<std::string> warnings = keep_times_of_one_machine(records);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].starts_with("runs of 2 builds of mwt, whose times are taken together: ")) << warnings[0];
  EXPECT_TRUE(records.runs[0].wall_time_s);
}

// As brute force: its "n^12.9" came without a remark.
TEST(Report, WhatIsNoPowerLawIsSaidSo) {
  std::vector<RunRecord> runs;
  for (const Index n : {8U, 9U, 10U, 11U, 12U, 13U}) {
    for (const double noise : {0.97, 1.0, 1.03}) {
      RunRecord& run = runs.emplace_back(power_law_runs().front());
      run.n = n;
      run.seed = runs.size();
      run.wall_time_s = 1e-6 * noise * std::pow(6.0, n - 8.0);
    }
  }
  const std::vector<Cell> cells = cells_of(runs);
  const std::vector<SeriesGrowth> growth = growth_of(cells);
  EXPECT_EQ(growth.at(0).time.value().fit(), Fit::no);
  EXPECT_NE(growth_tables(growth, Labels(cells)).find("no, x1."), std::string::npos);
  const std::vector<CsvRow> rows = parse_csv(exponents_csv("s", growth, Labels(cells)));
  EXPECT_EQ(rows[0].end()[-3], "fits");
  EXPECT_EQ(rows[1].end()[-3], "no");
  for (RunRecord& run : runs) *run.wall_time_s = 1e-6 * std::pow(run.n, 3) * (run.seed % 3 == 0 ? 0.97 : 1.01);
  EXPECT_EQ(growth_of(cells_of(runs)).at(0).time.value().fit(), Fit::yes);
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

TEST(Report, SaysHowManyRunsStoppedEarlyAndWhy) {
  std::vector<RunRecord> runs(4, power_law_runs().front());
  EXPECT_EQ(stopped_early_table(runs), "");
  runs[0].n = 30;
  runs[0].stop_reason = runs[1].stop_reason = StopReason::deadline;
  runs[2].stop_reason = StopReason::memory;
  EXPECT_EQ(stopped_early_table(runs),
            "stopped early  why                runs  first on\n"
            "sweep          too little memory     1  uniform n=10 seed=1\n"
            "sweep          at the time limit     2  uniform n=30 seed=1\n");
}

TEST(Report, WithoutRecordsItIsAMistake) {
  const testing::TestFolder folder;
  EXPECT_THROW(static_cast<void>(read_report_data(folder.path("missing"))), InputError);
  write_records(folder.path("empty"), {});
  EXPECT_THROW(static_cast<void>(read_report_data(folder.path("empty"))), InputError);
}

}  // namespace
}  // namespace mwt
