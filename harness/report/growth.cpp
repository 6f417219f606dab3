#include "harness/report/growth.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

namespace mwt {

namespace {

// The law of one measure over the cells of one series; nothing with too few sizes.
std::optional<Growth> growth_in(std::span<const Cell> series, std::vector<double> Cell::*observations) {
  std::vector<Measurement> measurements;
  std::set<Index> sizes;
  for (const Cell& cell : series) {
    for (const double value : cell.*observations) {
      if (!(value > 0)) continue;
      measurements.push_back({static_cast<double>(cell.key.n), value});
      sizes.insert(cell.key.n);
    }
  }
  if (sizes.size() < kMinSizes) return std::nullopt;
  Growth growth;
  growth.sizes = sizes.size();
  growth.observations = measurements.size();
  growth.min_n = *sizes.begin();
  growth.max_n = *sizes.rbegin();
  growth.law = fit_power_law(measurements).value();
  growth.lack_of_fit = test_lack_of_fit(measurements, growth.law);
  return growth;
}

constexpr double kLevelOfFit = 0.01;
constexpr double kMinMisfit = 1.1;

}  // namespace

Fit Growth::fit() const {
  if (!lack_of_fit.p_value) return Fit::untested;
  const bool is_off = *lack_of_fit.p_value < kLevelOfFit && lack_of_fit.max_misfit > kMinMisfit;
  return is_off ? Fit::no : Fit::yes;
}

std::vector<SeriesGrowth> growth_of(const std::vector<Cell>& cells) {
  std::vector<SeriesGrowth> all;
  for (auto begin = cells.begin(); begin != cells.end();) {
    const auto end =
        std::find_if(begin, cells.end(), [&](const Cell& cell) { return cell.key.series() != begin->key.series(); });
    const std::span<const Cell> series(begin, end);
    SeriesGrowth growth{begin->key.series(), growth_in(series, &Cell::times), growth_in(series, &Cell::alphas)};
    if (growth.time || growth.alpha) all.push_back(std::move(growth));
    begin = end;
  }
  return all;
}

}  // namespace mwt
