#include "harness/statistics/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "generators/random.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

/// Draws observations with replacement, each from its own group.
class Resampler {
 public:
  Resampler(std::size_t count, std::span<const std::size_t> groups) : members_of_(count) {
    std::map<std::size_t, std::size_t> position_of_group;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t group = groups.empty() ? 0 : groups[i];
      const auto [entry, is_new] = position_of_group.emplace(group, members_.size());
      if (is_new) members_.emplace_back();
      members_[entry->second].push_back(i);
      members_of_[i] = entry->second;
    }
  }

  void draw(RandomEngine& engine, std::vector<std::size_t>& drawn) const {
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const std::vector<std::size_t>& candidates = members_[members_of_[i]];
      drawn[i] = candidates[uniform_below(engine, candidates.size())];
    }
  }

 private:
  std::vector<std::vector<std::size_t>> members_;  // of each group
  std::vector<std::size_t> members_of_;            // the group of each observation, as a position in members_
};

void require_sensible(std::size_t count, const BootstrapOptions& options, std::span<const std::size_t> groups) {
  if (count == 0) throw std::invalid_argument("bootstrap without observations");
  if (!(options.confidence > 0 && options.confidence < 1) || options.resamples < 1)
    throw std::invalid_argument("bootstrap options out of range");
  if (!groups.empty() && groups.size() != count) throw std::invalid_argument("bootstrap with another number of groups");
}

void require_positive(std::span<const double> values) {
  const bool all = std::all_of(values.begin(), values.end(), [](double x) { return x > 0 && std::isfinite(x); });
  if (!all) throw std::invalid_argument("ratios need positive finite values");
}

/// The median of the chosen values; `buffer` saves allocations.
double median_of(std::span<const double> values, std::span<const std::size_t> chosen, std::vector<double>& buffer) {
  buffer.clear();
  for (const std::size_t i : chosen) buffer.push_back(values[i]);
  return quantile_in_place(buffer, 0.5);
}

}  // namespace

Estimate bootstrap_over(std::size_t count, const std::function<double(std::span<const std::size_t>)>& statistic,
                        const BootstrapOptions& options, std::span<const std::size_t> groups) {
  require_sensible(count, options, groups);
  const Resampler resampler(count, groups);
  std::vector<std::size_t> drawn(count);
  std::iota(drawn.begin(), drawn.end(), std::size_t{0});
  Estimate estimate;
  estimate.value = statistic(drawn);

  RandomEngine engine = make_engine("bootstrap", options.seed);
  std::vector<double> values(static_cast<std::size_t>(options.resamples));
  for (double& value : values) {
    resampler.draw(engine, drawn);
    value = statistic(drawn);
  }
  const double outside = (1 - options.confidence) / 2;
  estimate.lower = quantile_in_place(values, outside);
  estimate.upper = quantile_in_place(values, 1 - outside);
  return estimate;
}

Estimate bootstrap(std::span<const double> sample, const std::function<double(std::span<const double>)>& statistic,
                   const BootstrapOptions& options) {
  std::vector<double> resample;
  const auto statistic_of_drawn = [&](std::span<const std::size_t> drawn) {
    resample.clear();
    for (const std::size_t i : drawn) resample.push_back(sample[i]);
    return statistic(resample);
  };
  return bootstrap_over(sample.size(), statistic_of_drawn, options);
}

Estimate bootstrap_two_samples(std::span<const double> first, std::span<const double> second,
                               const std::function<double(std::span<const double>, std::span<const double>)>& statistic,
                               const BootstrapOptions& options) {
  if (first.empty() || second.empty()) throw std::invalid_argument("two samples need observations of both");
  std::vector<double> all(first.begin(), first.end());
  all.insert(all.end(), second.begin(), second.end());
  std::vector<std::size_t> groups(all.size(), 0);
  std::fill(groups.begin() + static_cast<std::ptrdiff_t>(first.size()), groups.end(), std::size_t{1});
  std::vector<double> resample(all.size());
  // A group's observations keep its places, so the first ones drawn are always of the first sample.
  const auto statistic_of_drawn = [&](std::span<const std::size_t> drawn) {
    for (std::size_t i = 0; i < drawn.size(); ++i) resample[i] = all[drawn[i]];
    const std::span<const double> both(resample);
    return statistic(both.first(first.size()), both.subspan(first.size()));
  };
  return bootstrap_over(all.size(), statistic_of_drawn, options, groups);
}

Estimate bootstrap_median(std::span<const double> sample, const BootstrapOptions& options) {
  return bootstrap(sample, median, options);
}

Estimate bootstrap_paired_ratio_of_medians(std::span<const double> numerators, std::span<const double> denominators,
                                           const BootstrapOptions& options) {
  if (numerators.size() != denominators.size()) throw std::invalid_argument("pairs need equally many of both");
  require_positive(numerators);
  require_positive(denominators);
  std::vector<double> buffer;
  const auto ratio = [&](std::span<const std::size_t> drawn) {
    return median_of(numerators, drawn, buffer) / median_of(denominators, drawn, buffer);
  };
  return bootstrap_over(numerators.size(), ratio, options);
}

Estimate bootstrap_ratio_of_medians(std::span<const double> numerators, std::span<const double> denominators,
                                    const BootstrapOptions& options) {
  require_positive(numerators);
  require_positive(denominators);
  const auto ratio = [](std::span<const double> above, std::span<const double> below) {
    return median(above) / median(below);
  };
  return bootstrap_two_samples(numerators, denominators, ratio, options);
}

}  // namespace mwt
