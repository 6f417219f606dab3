// The curves and points of the figures for a paper, as CSV.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/io/text/csv.h"
#include "harness/paper/paper_data.h"

namespace mwt {

/// The first row is the header.
using CsvRows = std::vector<CsvRow>;
[[nodiscard]] std::string csv_text(const CsvRows& rows);

/// E. D. Dolan, J. J. More, "Benchmarking optimization software with performance profiles", Mathematical Programming 91
/// (2002): the share of the common instances on which an algorithm's value is within a factor of the best one. Of the
/// gap: the weight over the lightest one's less 1, so that optimal triangulations have a ratio, too. Steps: `share` of
/// the instances have at most `ratio`. Failures never come in.
[[nodiscard]] CsvRows profile_rows(const PaperData& data, PaperMeasure measure);

/// The empirical distribution over the common instances: `share` have at most `value`. Of times: seconds per point.
[[nodiscard]] CsvRows distribution_rows(const PaperData& data, PaperMeasure measure);

/// For each n that has enough common instances, the mean gap against the median time, with 95% intervals, and whether
/// the algorithm is on the Pareto front: no other one is at least as good in both and better in one. At most four n,
/// the largest.
[[nodiscard]] CsvRows trade_off_rows(const PaperData& data);

/// The medians of time and means of alpha of summary.csv that the growth figure marks.
[[nodiscard]] CsvRows growth_point_rows(const ReportData& report, const PaperData& data,
                                        const std::vector<std::string>& families);

/// The power laws of exponents.csv as lines, with their bands, exponents and goodness of fit.
[[nodiscard]] CsvRows growth_line_rows(const ReportData& report, const PaperData& data,
                                       const std::vector<std::string>& families);

}  // namespace mwt
