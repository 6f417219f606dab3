#include "harness/statistics/change_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

constexpr std::size_t kShortestSeries = 6;
constexpr std::size_t kMaxLag = 5;
constexpr double kGrid = 0.1;    // distance of levels in units of the noise
constexpr long kGridReach = 20;  // levels to both sides of every value: 2 noises, beyond which none is worth having
constexpr double kWildest = 3;   // noises that a value lies off its level, where the autocorrelation is estimated
constexpr double kMaxCorrelation = 0.9;
constexpr double kCorrelationMargin = 0.8;  // over the root of the number of values; chosen, as the next, by simulation
constexpr double kLeastEvidence = 5.5;      // standard errors
constexpr double kWidest = 1e12;            // of the series in units of the noise: so that levels are exact integers

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

struct EvidentStep {
  std::size_t position = 0;
  double evidence = 0;  ///< the height in standard errors
  double error = 0;     ///< one of these
};

/// Which of the steps that explain a series are more than its noise does by itself, autocorrelated as it is.
class Evidence {
 public:
  /// The series in units of its noise. Precondition: positions ascend, none is 0 or beyond the series.
  Evidence(std::span<const double> series, const std::vector<std::size_t>& positions)
      : series_(series), cuts_(positions) {
    cuts_.insert(cuts_.begin(), 0);
    cuts_.push_back(series.size());
  }

  /// What is left after the least evident step was taken out as long as one is not evident.
  [[nodiscard]] std::vector<EvidentStep> evident_steps() {
    for (;;) {
      std::vector<EvidentStep> steps = judged_steps();
      const auto weakest = std::ranges::min_element(steps, {}, &EvidentStep::evidence);
      if (weakest == steps.end() || weakest->evidence >= kLeastEvidence) return steps;
      std::erase(cuts_, weakest->position);
    }
  }

 private:
  [[nodiscard]] std::span<const double> level(std::size_t i) const {
    return series_.subspan(cuts_[i], cuts_[i + 1] - cuts_[i]);
  }

  /// The autocorrelation of the distances from the levels, without the part that their estimation takes away (n values
  /// and k levels: rho becomes about rho - (k + 3 k rho) / n), and a margin for its own error.
  [[nodiscard]] double correlation() const {
    std::vector<double> distances;
    for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
      const double middle = median(level(i));
      for (const double value : level(i)) distances.push_back(std::clamp(value - middle, -kWildest, kWildest));
    }
    double products = 0, squares = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
      squares += distances[i] * distances[i];
      if (i > 0) products += distances[i] * distances[i - 1];
    }
    const double count = static_cast<double>(distances.size()), levels = static_cast<double>(cuts_.size() - 1);
    if (squares == 0 || count <= 3 * levels) return kMaxCorrelation;
    const double unbiased = (products / squares * count + levels) / (count - 3 * levels);
    return std::clamp(unbiased + kCorrelationMargin / std::sqrt(count), 0.0, kMaxCorrelation);
  }

  /// The variance of the mean of so many values in units of the noise's.
  static double variance_of_mean(std::size_t count, double correlation) {
    double sum = 1, power = 1;
    for (std::size_t lag = 1; lag < count; ++lag) {
      power *= correlation;
      sum += 2 * (1 - static_cast<double>(lag) / static_cast<double>(count)) * power;
    }
    return sum / static_cast<double>(count);
  }

  [[nodiscard]] std::vector<EvidentStep> judged_steps() const {
    const double rho = correlation();
    std::vector<EvidentStep> steps;
    for (std::size_t i = 1; i + 1 < cuts_.size(); ++i) {
      const double height = std::fabs(median(level(i)) - median(level(i - 1)));
      const double variance = variance_of_mean(level(i - 1).size(), rho) + variance_of_mean(level(i).size(), rho);
      const double error = std::sqrt(variance);
      steps.push_back({cuts_[i], height / error, error});
    }
    return steps;
  }

  std::span<const double> series_;
  std::vector<std::size_t> cuts_;  // 0, the steps, the end
};

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
                     median(series.subspan(positions[i], end - positions[i])), 0});
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
  const std::vector<std::size_t> positions = Staircase(scaled, options).steps();
  std::vector<std::size_t> evident;
  const std::vector<EvidentStep> judged = Evidence(scaled, positions).evident_steps();
  for (const EvidentStep& step : judged) evident.push_back(step.position);
  std::vector<Step> steps = with_levels(series, evident);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i].error = noise * judged[i].error;
  return steps;
}

std::vector<Step> find_steps_beyond(std::span<const double> series, double tolerance) {
  if (!(tolerance > 0)) throw std::invalid_argument("the tolerance is positive");
  std::vector<std::size_t> positions;
  std::vector<double> level;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const auto is_off = [&](double value) { return std::fabs(value - median(level)) > tolerance; };
    if (!level.empty() && is_off(series[i])) {
      if (i + 1 < series.size() && !is_off(series[i + 1])) continue;
      positions.push_back(i);
      level.clear();
    }
    level.push_back(series[i]);
  }
  return with_levels(series, positions);
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
