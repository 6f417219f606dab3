#include "harness/tracking/comparison/settle.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TrackedCell cell(const std::string& algorithm, Index n) { return {algorithm, "", "uniform", "", n, 1, 1}; }

TimeRow row(const std::string& algorithm, Verdict verdict, std::optional<TrackedCell> of_cell = {}) {
  TimeRow row;
  row.name = row.algorithm = algorithm;
  row.cell = std::move(of_cell);
  if (row.cell) row.instance = instance_label(*row.cell);
  row.verdict = verdict;
  return row;
}

/// Two algorithms with two cells each.
Comparison comparison_of(Verdict flip, Verdict flip_100, Verdict greedy, Verdict greedy_100) {
  Comparison comparison;
  comparison.algorithms = {row("flip", flip), row("greedy", greedy)};
  comparison.cells = {row("flip", flip_100, cell("flip", 100)), row("flip", Verdict::same, cell("flip", 200)),
                      row("greedy", greedy_100, cell("greedy", 100)),
                      row("greedy", Verdict::same, cell("greedy", 200))};
  comparison.compared_cells = 4;
  return comparison;
}

TEST(Settle, AnOpenAlgorithmOpensAllOfItsCells) {
  using enum Verdict;
  EXPECT_EQ(comparison_of(unclear, same, same, same).open_cells(), (std::set{cell("flip", 100), cell("flip", 200)}));
  EXPECT_EQ(comparison_of(same, same, improvement, unclear).open_cells(), std::set{cell("greedy", 100)});
  EXPECT_TRUE(comparison_of(same, not_slower, same, same).open_cells().empty());
  Comparison all = comparison_of(same, same, same, same);
  all.algorithms.push_back(row(kAllAlgorithms, unclear));
  EXPECT_EQ(all.open_cells().size(), 4u);
}

TEST(Settle, ATimeLimitReachedIsOpenAndACrashIsSure) {
  Comparison comparison = comparison_of(Verdict::same, Verdict::same, Verdict::same, Verdict::same);
  comparison.findings = {{cell("greedy", 200), Aspect::failures, true, "failed runs: none -> 1 of 3 (timeout)", true}};
  EXPECT_EQ(comparison.open_cells(), std::set{cell("greedy", 200)});
  EXPECT_FALSE(comparison.has_sure_regression());
  comparison.findings[0].depends_on_speed = false;
  EXPECT_TRUE(comparison.open_cells().empty());
  EXPECT_TRUE(comparison.has_sure_regression());
}

TEST(Settle, ARowKeepsItsFirstVerdictThatIsNotOpen) {
  using enum Verdict;
  Comparison all;
  const std::set<TrackedCell> cells = {cell("flip", 100), cell("flip", 200), cell("greedy", 100), cell("greedy", 200)};
  take_over(all, comparison_of(unclear, unclear, same, regression), cells);
  EXPECT_EQ(all.outcome(), Outcome::regression);
  take_over(all, comparison_of(same, not_slower, unclear, unclear), cells);
  EXPECT_EQ(all.algorithms[0].verdict, same);
  EXPECT_EQ(all.cells[0].verdict, not_slower);
  EXPECT_EQ(all.algorithms[1].verdict, same) << "it was settled before";
  EXPECT_EQ(all.cells[2].verdict, regression);
}

TEST(Settle, LaterFindingsReplaceThoseOfTheSameCells) {
  Comparison all, latest;
  all.findings = {{cell("flip", 100), Aspect::failures, true, "old", true},
                  {cell("greedy", 100), Aspect::failures, true, "other", true}};
  take_over(all, latest, {cell("flip", 100)});
  ASSERT_EQ(all.findings.size(), 1u);
  EXPECT_EQ(all.findings[0].text, "other");
}

TEST(Settle, TheOutcomeIsThatOfTheRunsInTurn) {
  using enum Verdict;
  Settled settled{comparison_of(regression, same, same, same), comparison_of(same, same, same, same), {}};
  EXPECT_EQ(settled.outcome(), Outcome::not_slower) << "the folders were wrong";
  settled.in_turn = comparison_of(unclear, same, same, same);
  EXPECT_EQ(settled.outcome(), Outcome::unclear);
  settled.in_turn = comparison_of(regression, same, same, same);
  EXPECT_EQ(settled.outcome(), Outcome::regression);
  settled.in_turn = comparison_of(same, same, same, same);
  settled.not_run = {cell("flip", 300)};
  EXPECT_EQ(settled.outcome(), Outcome::unclear);
  settled.folders.cells.push_back(row("flip", regression, cell("flip", 300)));
  EXPECT_EQ(settled.outcome(), Outcome::regression) << "what was not run keeps its verdict";
  settled.not_run.clear();
  EXPECT_EQ(settled.outcome(), Outcome::not_slower);
  settled.folders.findings = {{cell("flip", 100), Aspect::quality, true, "heavier"}};
  EXPECT_EQ(settled.outcome(), Outcome::regression) << "no load makes a triangulation heavier";
}

TEST(Settle, ANightOnAnotherMachineIsNotCompared) {
  Settled settled{comparison_of(Verdict::same, Verdict::same, Verdict::same, Verdict::same), std::nullopt, {}};
  EXPECT_EQ(settled.outcome(), Outcome::not_slower);
  settled.folders.cells_of_other_machines = 1;
  EXPECT_EQ(settled.outcome(), Outcome::not_compared);
}

}  // namespace
}  // namespace mwt
