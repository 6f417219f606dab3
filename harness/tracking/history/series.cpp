#include "harness/tracking/history/series.h"

#include <cmath>
#include <map>

#include "harness/statistics/quantile.h"
#include "harness/tracking/measures.h"

namespace mwt {

namespace {

/// Values of one seed, by nightly run.
using SeedValues = std::map<std::size_t, double>;

/// Where deviations are relative, values are averaged as logarithms.
bool is_relative(const std::string& measure) { return measure_named(measure).aspect != Aspect::failures; }

double median_of(const SeedValues& values) {
  std::vector<double> all;
  for (const auto& [nightly_run, value] : values) all.push_back(value);
  return median(all);
}

Series pooled(const SeriesKey& key, const std::map<std::uint64_t, SeedValues>& seeds) {
  std::map<std::size_t, std::pair<double, double>> deviations;  // by nightly run: their sum and number
  double level = 0;
  for (const auto& [seed, values] : seeds) {
    const double usual = median_of(values);
    level += usual / static_cast<double>(seeds.size());
    for (const auto& [nightly_run, value] : values) {
      deviations[nightly_run].first += value - usual;
      deviations[nightly_run].second += 1;
    }
  }
  Series series{key, {}, {}};
  for (const auto& [nightly_run, deviation] : deviations) {
    const double value = level + deviation.first / deviation.second;
    series.nightly_runs.push_back(nightly_run);
    series.values.push_back(is_relative(key.measure) ? std::exp(value) : value);
  }
  return series;
}

}  // namespace

std::vector<Series> series_of(const std::vector<NightlyRun>& nightly_runs) {
  std::map<SeriesKey, std::map<std::uint64_t, SeedValues>> seeds_of;
  for (std::size_t nightly_run = 0; nightly_run < nightly_runs.size(); ++nightly_run) {
    for (const NightlyValue& value : nightly_runs[nightly_run].values) {
      SeriesKey key{nightly_runs[nightly_run].study, nightly_runs[nightly_run].environment, value.cell, value.measure};
      key.cell.seed = 0;
      const bool relative = is_relative(value.measure);
      if (relative && !(value.value > 0)) continue;
      seeds_of[key][value.cell.seed][nightly_run] = relative ? std::log(value.value) : value.value;
    }
  }
  std::vector<Series> all;
  for (const auto& [key, seeds] : seeds_of) all.push_back(pooled(key, seeds));
  return all;
}

}  // namespace mwt
