// summary.csv, observations.csv, exponents.csv, optima.csv and ratings.csv: the figures of a report, for programs.
// results/README.md explains every column.
#pragma once

#include <string>
#include <vector>

#include "harness/report/cell_summary.h"
#include "harness/report/growth.h"
#include "harness/report/labels.h"
#include "harness/report/observations.h"
#include "harness/report/optima.h"

namespace mwt {

/// The content of summary.csv: one row per cell.
[[nodiscard]] std::string summary_csv(const std::string& study, const std::vector<CellSummary>& cells,
                                      const Labels& labels);

/// The content of observations.csv: one row per algorithm and instance.
[[nodiscard]] std::string observations_csv(const std::string& study, const std::vector<Observation>& observations,
                                           const Labels& labels);

/// The content of exponents.csv: one row per series and measure that has a law.
[[nodiscard]] std::string exponents_csv(const std::string& study, const std::vector<SeriesGrowth>& growth,
                                        const Labels& labels);

/// The content of optima.csv: one row per family and n.
[[nodiscard]] std::string optima_csv(const std::string& study, const std::vector<OptimumCell>& optima,
                                     const Labels& labels);

/// The content of ratings.csv: one row per run that is ok. `runs` are those of the report, rated_by_all_bounds().
[[nodiscard]] std::string ratings_csv(const std::string& study, const std::vector<RunRecord>& runs);

}  // namespace mwt
