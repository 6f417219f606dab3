#include "harness/report/cell_summary.h"

#include <functional>
#include <numeric>
#include <span>

#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

using Function = std::function<double(std::span<const double>)>;

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double p95(std::span<const double> values) { return quantile(values, 0.95); }

std::optional<Statistic> statistic(const std::vector<double>& observations, const Function& function) {
  if (observations.empty()) return std::nullopt;
  if (observations.size() < kMinForInterval) {
    const double value = function(observations);
    return Statistic{{value, value, value}, false};
  }
  return Statistic{bootstrap(observations, function), true};
}

}  // namespace

CellSummary summarise(const Cell& cell) {
  CellSummary summary;
  summary.cell = cell;
  summary.time = statistic(cell.times, median);
  summary.over_delaunay = statistic(cell.over_delaunay, median);
  if (!cell.peak_rss_bytes.empty()) summary.peak_rss_bytes = median(cell.peak_rss_bytes);
  summary.alpha_mean = statistic(cell.alphas, mean);
  summary.alpha_median = statistic(cell.alphas, median);
  summary.alpha_p95 = statistic(cell.alphas, p95);
  if (!cell.alphas.empty()) {
    summary.optimal_share = static_cast<double>(cell.optimal) / static_cast<double>(cell.alphas.size());
    summary.optimal_range = clopper_pearson(cell.optimal, cell.alphas.size());
  }
  return summary;
}

std::vector<CellSummary> summarise(const std::vector<Cell>& cells) {
  std::vector<CellSummary> summaries;
  for (const Cell& cell : cells) summaries.push_back(summarise(cell));
  return summaries;
}

}  // namespace mwt
