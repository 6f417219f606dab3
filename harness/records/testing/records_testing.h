// For tests only: records without what may differ between two executions of one study.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "harness/records/results_folder.h"

namespace mwt::testing {

/// The rows without when, where and how long.
template <class Record>
std::vector<CsvRow> lasting(const std::vector<Column<Record>>& columns, const std::vector<Record>& records) {
  const std::vector<std::string> passing = {"env_id",         "recorded_at",    "wall_time_s", "cpu_time_s",
                                            "iterations",     "peak_rss_bytes", "phases",      "delaunay_time_s",
                                            "optimum_time_s", "verify_time_s"};
  std::vector<CsvRow> rows;
  for (const Record& record : records) {
    rows.emplace_back();
    for (const Column<Record>& column : columns) {
      const bool passes = std::find(passing.begin(), passing.end(), column.name) != passing.end();
      if (!passes) rows.back().push_back(column.text_of(record));
    }
  }
  return rows;
}

}  // namespace mwt::testing
