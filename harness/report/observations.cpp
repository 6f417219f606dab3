#include "harness/report/observations.h"

#include <map>
#include <utility>

#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

// The repetitions of one algorithm on one instance.
struct Repeated {
  Observation observation;
  std::vector<double> times, peaks, lower_alphas, upper_alphas;

  void add(const RunRecord& run) {
    ++observation.runs;
    observation.instance_id = run.instance_id;
    if (is_failure(run.status)) ++observation.failures;
    if (run.status != RunStatus::ok) return;
    if (run.stopped_early.value_or(false)) ++observation.stopped_early;
    if (run.wall_time_s) times.push_back(*run.wall_time_s);
    if (run.peak_rss_bytes) peaks.push_back(static_cast<double>(*run.peak_rss_bytes));
    if (run.optimality != "proved" || !run.alpha_lower || !run.alpha_upper) return;
    lower_alphas.push_back(*run.alpha_lower);
    upper_alphas.push_back(*run.alpha_upper);
  }

  [[nodiscard]] Observation finished() const {
    const auto median_of = [](const std::vector<double>& values) {
      return values.empty() ? std::nullopt : std::optional(median(values));
    };
    Observation result = observation;
    result.time_s = median_of(times);
    result.peak_rss_bytes = median_of(peaks);
    result.alpha_lower = median_of(lower_alphas);
    result.alpha_upper = median_of(upper_alphas);
    return result;
  }
};

}  // namespace

std::vector<Observation> observations_of(const std::vector<RunRecord>& runs) {
  std::map<CellKey, std::map<std::uint64_t, Repeated>>
      by_cell;  // generator and n being equal, the seed is the instance
  for (const RunRecord& run : runs) {
    if (run.status == RunStatus::not_applicable) continue;
    const CellKey key{run.generator, run.generator_params, run.algorithm, run.params, run.n};
    Repeated& repeated = by_cell[key][run.seed];
    repeated.observation.key = key;
    repeated.observation.seed = run.seed;
    repeated.add(run);
  }
  std::vector<Observation> observations;
  for (const Cell& cell : cells_of(runs)) {
    const auto found = by_cell.find(cell.key);
    if (found == by_cell.end()) continue;
    for (const auto& [seed, repeated] : found->second) observations.push_back(repeated.finished());
  }
  return observations;
}

}  // namespace mwt
