#include "harness/report/side_by_side.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/io/testing/folder_testing.h"
#include "harness/io/text/csv.h"

namespace mwt {
namespace {

RunRecord run_of(const std::string& algorithm, Index n, std::uint64_t seed, double time, double alpha) {
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

// `slower` times as slow, and with `excess` more alpha, on six instances of 50 points; one size of its own.
StudyRecords study_of(double slower, double excess, Index own_size) {
  StudyRecords records;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const double step = static_cast<double>(seed);
    records.runs.push_back(run_of("sweep", 50, seed, slower * step, 1 + step / 8 + excess));
  }
  records.runs.push_back(run_of("greedy", own_size, 1, 1, 1));
  return records;
}

class SideBySideTest : public ::testing::Test {
 protected:
  ReportData data_of(const std::string& name, const StudyRecords& records) {
    write_records(folder_.path(name), records);
    return read_report_data(folder_.path(name));
  }

  testing::TestFolder folder_;
};

TEST_F(SideBySideTest, RatiosAreOfPairsOnTheSameInstances) {
  const ReportData a = data_of("a", study_of(1, 0, 10)), b = data_of("b", study_of(2, 0.5, 20));
  const SideBySide both = side_by_side(a, b);
  ASSERT_EQ(both.cells.size(), 3u);
  const auto sweep = std::ranges::find(both.cells, "sweep", [](const PairedCell& cell) { return cell.key.algorithm; });
  EXPECT_EQ(sweep->common_instances, 6u);
  EXPECT_DOUBLE_EQ(sweep->time_ratio->estimate.value, 2);
  EXPECT_DOUBLE_EQ(sweep->time_ratio->estimate.lower, 2) << "every pair has this ratio";
  EXPECT_DOUBLE_EQ(sweep->time_ratio->estimate.upper, 2);
  EXPECT_DOUBLE_EQ(sweep->alpha_change->estimate.value, 0.5);
  EXPECT_DOUBLE_EQ(sweep->alpha_change->estimate.upper, 0.5);
  const auto only_a = std::ranges::find(both.cells, 10u, [](const PairedCell& cell) { return cell.key.n; });
  EXPECT_TRUE(only_a->a != nullptr && only_a->b == nullptr);
  EXPECT_FALSE(only_a->time_ratio);
}

TEST_F(SideBySideTest, OtherInstancesAreToldAndNotPaired) {
  StudyRecords others = study_of(2, 0.5, 10);
  for (RunRecord& run : others.runs) run.instance_id += "'";
  const ReportData a = data_of("a", study_of(1, 0, 10)), b = data_of("b", others);
  const SideBySide both = side_by_side(a, b);
  EXPECT_EQ(both.cells.at(0).common_instances, 0u);
  const Statistic& ratio = both.cells.at(0).time_ratio ? *both.cells.at(0).time_ratio : *both.cells.at(1).time_ratio;
  EXPECT_DOUBLE_EQ(ratio.estimate.value, 2);
  EXPECT_LT(both.cells.at(0).key.n == 50 ? ratio.estimate.lower : 0, 2);
  ASSERT_EQ(both.warnings.size(), 1u);
  EXPECT_NE(both.warnings[0].find("different instances"), std::string::npos);
}

TEST_F(SideBySideTest, WhatDiffersInPlanIsListedAndNothingElse) {
  StudyRecords changed = study_of(1, 0, 20);
  for (RunRecord& run : changed.runs) run.time_limit_s = 5;
  const ReportData a = data_of("a", study_of(1, 0, 10)), b = data_of("b", changed);
  const SideBySide both = side_by_side(a, b);
  ASSERT_EQ(both.differences.size(), 2u);
  EXPECT_EQ(both.differences[0].aspect, "sizes");
  EXPECT_EQ(both.differences[0].only_a, std::vector<std::string>{"10"});
  EXPECT_EQ(both.differences[0].only_b, std::vector<std::string>{"20"});
  EXPECT_EQ(both.differences[1].aspect, "time limit in s");
  const std::string text = side_by_side_text(both);
  EXPECT_NE(text.find("only in A"), std::string::npos);
  EXPECT_NE(text.find("only B"), std::string::npos);
  const ReportData same = data_of("same", study_of(1, 0, 10));
  EXPECT_NE(side_by_side_text(side_by_side(a, same)).find("do not differ"), std::string::npos);
}

TEST_F(SideBySideTest, FilesHaveOneRowPerCellAndDifference) {
  const ReportData a = data_of("a", study_of(1, 0, 10)), b = data_of("b", study_of(2, 0.5, 20));
  const SideBySide both = side_by_side(a, b);
  const std::vector<CsvRow> cells = parse_csv(side_by_side_cells_csv(both));
  ASSERT_EQ(cells.size(), 4u);
  for (const CsvRow& row : cells) EXPECT_EQ(row.size(), cells[0].size());
  EXPECT_EQ(cells[0].back(), "alpha_change_upper");
  const std::vector<CsvRow> plan = parse_csv(side_by_side_plan_csv(both));
  EXPECT_EQ(plan.at(1), (CsvRow{"folder", folder_.path("a"), folder_.path("b")}));
  EXPECT_EQ(plan.back(), (CsvRow{"sizes", "10", "20"}));
}

}  // namespace
}  // namespace mwt
