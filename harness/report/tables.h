// The tables of a report, for people.
//
// Alphas are upper ends of certified intervals, so that none is better than it looks, and only of runs with a proved
// optimum; "-" where there is none. Intervals are 95% ones.
#pragma once

#include <string>
#include <vector>

#include "harness/report/cell_summary.h"
#include "harness/report/growth.h"
#include "harness/report/labels.h"

namespace mwt {

/// One line per algorithm, over all its instances: runs, failures, not applicable, alpha.
[[nodiscard]] std::string algorithm_table(const std::vector<Cell>& cells, const Labels& labels);

/// One table per family, one line per algorithm and n. Cells where the algorithm is not applicable are left out.
/// Where the Delaunay time was measured, the last column gives the time in units of it.
[[nodiscard]] std::string cell_tables(const std::vector<CellSummary>& cells, const Labels& labels);

/// One table per family, one line per algorithm: the exponents of time and alpha. Empty without any.
[[nodiscard]] std::string growth_tables(const std::vector<SeriesGrowth>& growth, const Labels& labels);

}  // namespace mwt
