// Two studies side by side: the cells of both with ratios, and in what their plans differ.
//
// For a verdict on a change of the program use tracking/comparison/; this states what was measured, and judges nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/report/report.h"

namespace mwt {

/// One algorithm on one family and size, in at least one of two studies.
struct PairedCell {
  CellKey key;
  const CellSummary* a = nullptr;  ///< null: the study has no such runs
  const CellSummary* b = nullptr;
  std::size_t common_instances = 0;       ///< with runs that are ok in both
  std::optional<Statistic> time_ratio;    ///< median of B over that of A
  std::optional<Statistic> alpha_change;  ///< mean alpha of B minus that of A; below 0 where B is better
};

/// What is planned or was used in one study only, by aspect: "sizes", "algorithms", "time limit in s", ...
struct PlanDifference {
  std::string aspect;
  std::vector<std::string> only_a;
  std::vector<std::string> only_b;
};

struct SideBySide {
  const ReportData* a = nullptr;
  const ReportData* b = nullptr;
  Labels labels;  ///< of the configurations of both
  std::vector<PairedCell> cells;
  std::vector<PlanDifference> differences;  ///< aspects that differ
  std::vector<std::string> warnings;        ///< what makes ratios doubtful, one line each
};

/// Families in the order of A, algorithms in the order of the registry, sizes ascending. Intervals are 95% bootstrap
/// ones where both cells have kMinForInterval observations: where both ran on the same instances, pairs are drawn.
/// Deterministic. The result must not outlive `a` and `b`.
[[nodiscard]] SideBySide side_by_side(const ReportData& a, const ReportData& b);

/// For people: what differs in plan, then a table per family.
[[nodiscard]] std::string side_by_side_text(const SideBySide& both);

/// The content of cells.csv and plan.csv; results/README.md explains the columns.
[[nodiscard]] std::string side_by_side_cells_csv(const SideBySide& both);
[[nodiscard]] std::string side_by_side_plan_csv(const SideBySide& both);

}  // namespace mwt
