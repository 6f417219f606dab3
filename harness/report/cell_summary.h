// The summary of a cell: values, with intervals where there are enough observations.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/report/cells.h"
#include "harness/statistics/binomial_interval.h"
#include "harness/statistics/bootstrap.h"

namespace mwt {

/// Fewer observations give no interval: the bootstrap's would be far too short. Even that of the median of five covers
/// the truth in at most 94% of all cases (it lies within their range in 1 - 2 / 2^5).
inline constexpr std::size_t kMinForInterval = 5;

/// A statistic of the observations, with its 95% bootstrap interval. Without one both ends equal the value.
struct Statistic {
  Estimate estimate;
  bool has_interval = false;
};

/// Statistics without observations are missing. Those of alpha are over instances with a proved optimum.
struct CellSummary {
  Cell cell;
  std::optional<Statistic> time;           ///< median, s
  std::optional<Statistic> over_delaunay;  ///< median of time over the Delaunay time's
  std::optional<double> peak_rss_bytes;    ///< median
  std::optional<Statistic> alpha_mean;
  std::optional<Statistic> alpha_median;
  std::optional<Statistic> alpha_p95;
  std::optional<double> optimal_share;               ///< of the instances with a proved optimum
  std::optional<ProbabilityInterval> optimal_range;  ///< 95%, Clopper and Pearson
};

/// Deterministic.
[[nodiscard]] CellSummary summarise(const Cell& cell);
[[nodiscard]] std::vector<CellSummary> summarise(const std::vector<Cell>& cells);

}  // namespace mwt
