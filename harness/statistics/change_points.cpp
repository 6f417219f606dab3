#include "harness/statistics/change_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>

#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

constexpr std::size_t kShortestSeries = 6;
constexpr std::size_t kMaxLag = 5;
constexpr double kGrid = 0.1;     // distance of levels in units of the noise
constexpr long kGridReach = 20;   // levels to both sides of every value: 2 noises, beyond which none is worth having
constexpr double kWidest = 1e12;  // of the series in units of the noise: so that levels are exact integers

/// The standard deviation of the values, estimated from their differences over `lag` places, for normal noise.
double noise_at_lag(std::span<const double> series, std::size_t lag) {
  std::vector<double> sizes;
  for (std::size_t i = lag; i < series.size(); ++i) sizes.push_back(std::fabs(series[i] - series[i - lag]));
  constexpr double kDeviationsPerMedian = 1.4826022185056018;  // 1 / the 75% quantile of the standard normal
  return sizes.empty() ? 0 : kDeviationsPerMedian / std::sqrt(2.0) * quantile_in_place(sizes, 0.5);
}

std::vector<double> levels_near(const std::vector<double>& values) {
  std::set<long> places;
  for (const double value : values) {
    const long nearest = std::lround(value / kGrid);
    for (long k = nearest - kGridReach; k <= nearest + kGridReach; ++k) places.insert(k);
  }
  std::vector<double> levels;
  for (const long place : places) levels.push_back(static_cast<double>(place) * kGrid);
  return levels;
}

/// Dynamic programming over the values and the level that each is explained by.
class Staircase {
 public:
  Staircase(const std::vector<double>& values, const StepOptions& options)
      : values_(values), options_(options), levels_(levels_near(values)), cost_(levels_.size(), 0.0) {
    came_by_step_.assign(values.size(), std::vector<bool>(levels_.size(), false));
    best_before_.assign(values.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i) explain(i);
  }

  /// The positions at which the cheapest explanation steps.
  [[nodiscard]] std::vector<std::size_t> steps() const {
    std::vector<std::size_t> positions;
    std::size_t level = cheapest();
    for (std::size_t i = values_.size(); i-- > 1;) {
      if (!came_by_step_[i][level]) continue;
      positions.push_back(i);
      level = best_before_[i];
    }
    std::reverse(positions.begin(), positions.end());
    return positions;
  }

 private:
  [[nodiscard]] std::size_t cheapest() const {
    return static_cast<std::size_t>(std::min_element(cost_.begin(), cost_.end()) - cost_.begin());
  }

  void explain(std::size_t i) {
    best_before_[i] = cheapest();
    const double by_step = i == 0 ? std::numeric_limits<double>::infinity() : cost_[best_before_[i]] + options_.penalty;
    for (std::size_t level = 0; level < levels_.size(); ++level) {
      came_by_step_[i][level] = by_step < cost_[level];
      const double distance = std::min(std::fabs(values_[i] - levels_[level]), options_.clip);
      cost_[level] = std::min(cost_[level], by_step) + distance * distance;
    }
  }

  const std::vector<double>& values_;
  const StepOptions& options_;
  std::vector<double> levels_;
  std::vector<double> cost_;  // of the cheapest explanation so far that ends at each level
  std::vector<std::vector<bool>> came_by_step_;
  std::vector<std::size_t> best_before_;
};

std::vector<Step> with_levels(std::span<const double> series, const std::vector<std::size_t>& positions) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::size_t begin = i == 0 ? 0 : positions[i - 1];
    const std::size_t end = i + 1 < positions.size() ? positions[i + 1] : series.size();
    steps.push_back({positions[i], median(series.subspan(begin, positions[i] - begin)),
                     median(series.subspan(positions[i], end - positions[i]))});
  }
  return steps;
}

void require_usable(std::span<const double> series, const StepOptions& options) {
  const bool finite = std::all_of(series.begin(), series.end(), [](double value) { return std::isfinite(value); });
  if (!finite) throw std::invalid_argument("a series with values that are not finite");
  if (!(options.penalty > 0) || !(options.clip > 0)) throw std::invalid_argument("penalty and clip are positive");
}

}  // namespace

double noise_of_series(std::span<const double> series) {
  double noise = 0;
  for (std::size_t lag = 1; lag <= kMaxLag; ++lag) noise = std::max(noise, noise_at_lag(series, lag));
  return noise;
}

std::vector<Step> find_steps(std::span<const double> series, const StepOptions& options) {
  require_usable(series, options);
  if (series.size() < kShortestSeries) return {};
  const double middle = median(series);
  const auto [smallest, largest] = std::minmax_element(series.begin(), series.end());
  const double noise = std::max({noise_of_series(series), options.min_noise, (*largest - *smallest) / kWidest});
  if (noise == 0) return {};  // all values are equal
  std::vector<double> scaled;
  for (const double value : series) scaled.push_back((value - middle) / noise);
  return with_levels(series, Staircase(scaled, options).steps());
}

std::vector<Step> find_exact_steps(std::span<const double> series) {
  std::vector<std::size_t> positions;
  for (std::size_t i = 1; i < series.size(); ++i) {
    const bool ends_spike = i >= 2 && series[i] == series[i - 2];
    const bool begins_spike = i + 1 < series.size() && series[i + 1] == series[i - 1];
    if (series[i] != series[i - 1] && !begins_spike && !ends_spike) positions.push_back(i);
  }
  return with_levels(series, positions);
}

}  // namespace mwt
