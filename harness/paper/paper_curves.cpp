#include "harness/paper/paper_curves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "base/number_text.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

constexpr std::size_t kMostSizes = 4;   // panels of the trade-off
constexpr std::size_t kBandPlaces = 9;  // where the band of a line is computed

double mean_of_gaps(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// Adds the steps of one empirical distribution.
void add_steps(CsvRows& rows, const std::string& label, std::vector<double> values) {
  const auto count = static_cast<double>(values.size());
  std::erase_if(values, [](double value) { return std::isinf(value); });
  std::ranges::sort(values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i + 1 < values.size() && values[i + 1] == values[i]) continue;
    rows.push_back({label, number_text(values[i]), number_text(static_cast<double>(i + 1) / count)});
  }
  if (values.empty()) rows.push_back({label, "", "0"});
}

// One algorithm at one n.
struct TradeOff {
  std::size_t algorithm = 0;
  std::vector<double> times, gaps;
  Estimate time, gap;
  bool is_complete = false;  // no failure
};

Estimate estimate_of(const std::vector<double>& values,
                     const std::function<double(std::span<const double>)>& function) {
  if (values.size() >= kMinForInterval) return bootstrap(values, function);
  const double value = function(values);
  return {value, value, value};
}

TradeOff trade_off_of(const PaperData& data, std::size_t algorithm, const std::vector<std::size_t>& instances) {
  TradeOff result;
  result.algorithm = algorithm;
  for (const std::size_t i : instances) {
    if (data.outcomes[algorithm][i].status != "ok" || !data.outcomes[algorithm][i].time_s) continue;
    result.times.push_back(data.value(PaperMeasure::time, algorithm, i));
    result.gaps.push_back(data.value(PaperMeasure::gap, algorithm, i));
  }
  result.is_complete = result.times.size() == instances.size();
  if (result.times.empty()) return result;
  result.time = estimate_of(result.times, median);
  result.gap = estimate_of(result.gaps, mean_of_gaps);
  return result;
}

bool dominates(const TradeOff& a, const TradeOff& b) {
  const bool at_least = a.is_complete && a.time.value <= b.time.value && a.gap.value <= b.gap.value;
  return at_least && (a.time.value < b.time.value || a.gap.value < b.gap.value);
}

// The common instances by n, of those n that have enough.
std::map<Index, std::vector<std::size_t>> instances_by_n(const PaperData& data) {
  std::map<Index, std::vector<std::size_t>> by_n;
  for (const std::size_t i : data.common(PaperMeasure::gap)) by_n[data.instances[i].n].push_back(i);
  const auto has_few = [](const auto& entry) { return entry.second.size() < kMinForInterval; };
  if (!std::ranges::all_of(by_n, has_few)) std::erase_if(by_n, has_few);
  while (by_n.size() > kMostSizes) by_n.erase(by_n.begin());
  return by_n;
}

bool is_shown(const PaperData& data, const std::vector<std::string>& families, const std::string& family,
              const std::string& label) {
  return std::ranges::find(families, family) != families.end() &&
         std::ranges::find(data.algorithms, label) != data.algorithms.end();
}

std::string end_of(const std::optional<Statistic>& statistic, double Estimate::*end) {
  return statistic && statistic->has_interval ? number_text(statistic->estimate.*end) : "";
}

std::vector<double> places_between(double low, double high) {
  std::vector<double> places;
  for (std::size_t i = 0; i < kBandPlaces; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kBandPlaces - 1);
    places.push_back(low * std::pow(high / low, share));
  }
  return places;
}

void add_line(CsvRows& rows, const CsvRow& name, const Growth& growth, const std::vector<Measurement>& measurements) {
  const std::vector<double> places =
      places_between(static_cast<double>(growth.min_n), static_cast<double>(growth.max_n));
  const std::vector<Estimate> band = power_law_band(measurements, places);
  const PowerLaw& law = growth.law;
  const auto end = [&](double value) { return law.has_interval ? number_text(value) : std::string(); };
  const char* fits = growth.fit() == Fit::yes ? "yes" : growth.fit() == Fit::no ? "no" : "untested";
  for (std::size_t i = 0; i < places.size(); ++i) {
    CsvRow row = name;
    row.insert(row.end(), {number_text(places[i]), number_text(band[i].value), end(band[i].lower), end(band[i].upper),
                           number_text(law.exponent.value), end(law.exponent.lower), end(law.exponent.upper),
                           law.r_squared ? number_text(*law.r_squared) : "", fits});
    rows.push_back(row);
  }
}

std::vector<Measurement> measurements_of(const ReportData& report, const CellKey& series,
                                         std::vector<double> Cell::*observations) {
  std::vector<Measurement> measurements;
  for (const Cell& cell : report.cells) {
    if (cell.key.series() != series) continue;
    for (const double value : cell.*observations) {
      if (value > 0) measurements.push_back({static_cast<double>(cell.key.n), value});
    }
  }
  return measurements;
}

}  // namespace

std::string csv_text(const CsvRows& rows) {
  std::string text;
  for (const CsvRow& row : rows) text += csv_line(row);
  return text;
}

CsvRows profile_rows(const PaperData& data, PaperMeasure measure) {
  const std::vector<std::size_t> instances = data.common(measure);
  const double shift = measure == PaperMeasure::gap ? 1 : 0;  // from gaps to weights
  std::vector<double> best(instances.size(), kPaperFailure);
  for (std::size_t a = 0; a < data.algorithms.size(); ++a) {
    const std::vector<double> values = data.values(measure, a, instances);
    for (std::size_t i = 0; i < values.size(); ++i) best[i] = std::min(best[i], shift + values[i]);
  }
  CsvRows rows = {{"label", "ratio", "share"}};
  for (std::size_t a = 0; a < data.algorithms.size(); ++a) {
    std::vector<double> ratios = data.values(measure, a, instances);
    for (std::size_t i = 0; i < ratios.size(); ++i)
      ratios[i] = std::isinf(ratios[i]) ? kPaperFailure : (shift + ratios[i]) / best[i] - shift;
    add_steps(rows, data.algorithms[a], ratios);
  }
  return rows;
}

CsvRows distribution_rows(const PaperData& data, PaperMeasure measure) {
  const std::vector<std::size_t> instances = data.common(measure);
  CsvRows rows = {{"label", "value", "share"}};
  for (std::size_t a = 0; a < data.algorithms.size(); ++a) {
    std::vector<double> values = data.values(measure, a, instances);
    for (std::size_t i = 0; measure == PaperMeasure::time && i < values.size(); ++i)
      values[i] /= static_cast<double>(data.instances[instances[i]].n);
    add_steps(rows, data.algorithms[a], values);
  }
  return rows;
}

CsvRows trade_off_rows(const PaperData& data) {
  CsvRows rows = {{"n", "label", "instances", "failures", "time_median_s", "time_median_s_lower", "time_median_s_upper",
                   "gap_mean", "gap_mean_lower", "gap_mean_upper", "is_pareto"}};
  for (const auto& [n, instances] : instances_by_n(data)) {
    std::vector<TradeOff> all;
    for (std::size_t a = 0; a < data.algorithms.size(); ++a) {
      TradeOff point = trade_off_of(data, a, instances);
      if (!point.times.empty()) all.push_back(std::move(point));
    }
    for (const TradeOff& point : all) {
      const auto is_worse = [&](const TradeOff& other) { return dominates(other, point); };
      const bool is_pareto = point.is_complete && std::ranges::none_of(all, is_worse);
      const bool has_interval = point.times.size() >= kMinForInterval;
      const auto end = [&](double value) { return has_interval ? number_text(value) : std::string(); };
      rows.push_back({std::to_string(n), data.algorithms[point.algorithm], std::to_string(point.times.size()),
                      std::to_string(instances.size() - point.times.size()), number_text(point.time.value),
                      end(point.time.lower), end(point.time.upper), number_text(point.gap.value), end(point.gap.lower),
                      end(point.gap.upper), is_pareto ? "1" : "0"});
    }
  }
  return rows;
}

CsvRows growth_point_rows(const ReportData& report, const PaperData& data, const std::vector<std::string>& families) {
  CsvRows rows = {{"measure", "family", "label", "n", "value", "lower", "upper"}};
  for (const CellSummary& summary : report.summaries) {
    const CellKey& key = summary.cell.key;
    const std::string family = report.labels.family(key);
    const std::string label = report.labels.algorithm(key);
    if (!is_shown(data, families, family, label)) continue;
    const auto add = [&](const std::string& measure, const std::optional<Statistic>& statistic) {
      if (!statistic) return;
      rows.push_back({measure, family, label, std::to_string(key.n), number_text(statistic->estimate.value),
                      end_of(statistic, &Estimate::lower), end_of(statistic, &Estimate::upper)});
    };
    add("time", summary.time);
    add("alpha", summary.alpha_mean);
  }
  return rows;
}

CsvRows growth_line_rows(const ReportData& report, const PaperData& data, const std::vector<std::string>& families) {
  CsvRows rows = {{"measure", "family", "label", "n", "value", "lower", "upper", "exponent", "exponent_lower",
                   "exponent_upper", "r_squared", "fits"}};
  for (const SeriesGrowth& series : report.growth) {
    const std::string family = report.labels.family(series.series);
    const std::string label = report.labels.algorithm(series.series);
    if (!is_shown(data, families, family, label)) continue;
    if (series.time)
      add_line(rows, {"time", family, label}, *series.time, measurements_of(report, series.series, &Cell::times));
    if (series.alpha)
      add_line(rows, {"alpha", family, label}, *series.alpha, measurements_of(report, series.series, &Cell::alphas));
  }
  return rows;
}

}  // namespace mwt
