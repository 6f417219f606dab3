// The tables for a paper, as CSV and as LaTeX. The best value is bold only where a corrected paired test says so.
#pragma once

#include <string>
#include <vector>

#include "harness/paper/latex.h"
#include "harness/paper/paper_comparisons.h"
#include "harness/paper/paper_curves.h"

namespace mwt {

struct PaperTable {
  CsvRows csv;
  LatexTable latex;
};

/// A block of rows over all common instances, then one per family: instances, failures, mean gap with its interval,
/// median, 95% quantile, maximum, share of optimal triangulations. Statistics of an algorithm are over the instances on
/// which it did not fail. Mean and median of the algorithm are bold that is significantly better than each other one on
/// the block's instances, adjusted over all pairs and blocks, where they are the block's smallest.
[[nodiscard]] PaperTable quality_table(const PaperData& data, const std::vector<std::string>& families);

/// A block per family, a column per n: the median time of summary.csv with its interval, in ms. The time is bold where
/// the same test, of the times, says that it is smaller than each other one, adjusted over all pairs and cells.
[[nodiscard]] PaperTable time_table(const ReportData& report, const PaperData& data,
                                    const std::vector<std::string>& families);

/// A block per family, a row per algorithm: the exponents of time and of alpha in n of exponents.csv, with intervals,
/// the explained share of the variance, and a mark where a power law does not fit. No rows without any law.
[[nodiscard]] PaperTable growth_table(const ReportData& report, const PaperData& data,
                                      const std::vector<std::string>& families);

/// One row per pair: instances, how often either is better, p-values, effect size, the shift with its interval.
[[nodiscard]] CsvRows pair_rows(const PaperData& data, PaperMeasure measure);

/// Mean ranks, Friedman's test and the critical difference, one row per algorithm; then the groups within which no
/// difference is significant, as first and last mean rank.
[[nodiscard]] CsvRows rank_rows(const PaperData& data, PaperMeasure measure);
[[nodiscard]] CsvRows rank_group_rows(const PaperData& data, PaperMeasure measure);

/// Every outcome that the tables and figures are made from.
[[nodiscard]] CsvRows outcome_rows(const PaperData& data);

}  // namespace mwt
