#include "harness/claims/selection.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>

#include "base/number_text.h"
#include "base/parameters.h"
#include "harness/io/text/text.h"
#include "harness/study/plan.h"

namespace mwt {

namespace {

RunGroups grouped_by(const Runs& runs, std::string RunRecord::*key) {
  RunGroups groups;
  for (const RunRecord* run : runs) groups[run->*key].push_back(run);
  return groups;
}

bool is_rated(const RunRecord& run) {
  return run.optimality == "proved" && run.alpha_lower.has_value() && run.alpha_upper.has_value();
}

}  // namespace

Runs finished_runs(const StudyRecords& records, const RunTest& test) {
  Runs result;
  for (const RunRecord& run : records.runs) {
    const bool is_finished = run.status == RunStatus::ok && run.stopped_early != true;
    if (is_finished && run.repetition == 0 && test(run)) result.push_back(&run);
  }
  return result;
}

Runs rated_runs(const StudyRecords& records, const RunTest& test) {
  return finished_runs(records, [&](const RunRecord& run) { return is_rated(run) && test(run); });
}

RunGroups by_family(const Runs& runs) { return grouped_by(runs, &RunRecord::generator); }

RunGroups by_growing_family(const Runs& runs) {
  RunGroups groups = by_family(runs);
  groups.erase(kFileGenerator);
  return groups;
}

RunGroups by_algorithm(const Runs& runs) { return grouped_by(runs, &RunRecord::algorithm); }

bool is_typical(const RunRecord& run) {
  static const std::set<std::string, std::less<>> families = {"uniform", "normal", "clustered", kFileGenerator};
  return families.contains(run.generator);
}

bool is_greedy(const RunRecord& run) { return run.algorithm == "greedy_naive" || run.algorithm == "greedy"; }

std::vector<double> alphas(const Runs& runs) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const RunRecord* run : runs) values.push_back(*run->alpha_upper);
  return values;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<std::string> named_value(std::string_view field, std::string_view name) {
  const std::map<std::string, std::string> values = parse_canonical(field);
  const auto value = values.find(std::string(name));
  return value == values.end() ? std::nullopt : std::optional(value->second);
}

const RunRecord& worst(const Runs& runs) {
  return **std::max_element(runs.begin(), runs.end(),
                            [](const RunRecord* a, const RunRecord* b) { return *a->alpha_upper < *b->alpha_upper; });
}

std::optional<PowerLaw> growth_of(const Runs& runs, const RunValue& value, std::size_t min_sizes) {
  std::vector<Measurement> measurements;
  std::set<Index> sizes;
  for (const RunRecord* run : runs) {
    const std::optional<double> y = value(*run);
    if (!y || !(*y > 0) || !std::isfinite(*y)) continue;
    measurements.push_back({static_cast<double>(run->n), *y});
    sizes.insert(run->n);
  }
  if (sizes.size() < std::max<std::size_t>(min_sizes, 2)) return std::nullopt;
  return fit_power_law(measurements);
}

std::string exponent_text(const PowerLaw& law) {
  const auto shown = [](double exponent) { return fixed(std::abs(exponent) < 0.005 ? 0 : exponent, 2); };
  if (!law.has_interval) return shown(law.exponent.value);
  return fmt::format("{} ({} to {})", shown(law.exponent.value), shown(law.exponent.lower), shown(law.exponent.upper));
}

std::string significant(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return fixed(value, 0);
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fixed(value, std::max(0, digits - 1 - magnitude));
}

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (auto place = static_cast<std::ptrdiff_t>(text.size()) - 3; place > 0; place -= 3) {
    text.insert(static_cast<std::size_t>(place), 1, ',');
  }
  return text;
}

std::string size_range(const Runs& runs) {
  const auto [low, high] =
      std::minmax_element(runs.begin(), runs.end(), [](const RunRecord* a, const RunRecord* b) { return a->n < b->n; });
  if ((*low)->n == (*high)->n) return "n = " + grouped((*low)->n);
  return "n = " + grouped((*low)->n) + " to " + grouped((*high)->n);
}

}  // namespace mwt
