// What `mwt report` makes of the records of a study: tables for people, files for programs.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "harness/records/results_folder.h"
#include "harness/report/cell_summary.h"
#include "harness/report/growth.h"
#include "harness/report/labels.h"
#include "harness/report/optima.h"

namespace mwt {

/// Everything that the parts of a report are made from, computed once.
struct ReportData {
  std::string folder;
  StudyRecords records;               ///< the runs rated_by_all_bounds(), with times of one machine only
  std::vector<std::string> warnings;  ///< of keep_times_of_one_machine()
  std::vector<Cell> cells;
  std::vector<CellSummary> summaries;
  std::vector<SeriesGrowth> growth;
  std::vector<OptimumCell> optima;
  Labels labels;
};

/// Throws InputError as read_records(), and if there are no runs yet.
[[nodiscard]] ReportData read_report_data(const std::string& folder);

/// One part of a report: prints to `out`, or writes files in the folder and prints their names. To add one: its
/// function, and its line in report_tables() or report_results().
using ReportPart = std::function<void(const ReportData& data, std::ostream& out)>;

/// All numbers as tables, pages of them; the most useful first.
[[nodiscard]] std::vector<ReportPart> report_tables();

/// What follows from the numbers, a page at most: files for programs, verdicts.
[[nodiscard]] std::vector<ReportPart> report_results();

}  // namespace mwt
