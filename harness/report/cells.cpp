#include "harness/report/cells.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "algorithms/registry.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

// The runs of one cell on one instance.
struct Observed {
  std::vector<double> times;
  std::vector<double> over_delaunay;
  std::vector<double> peaks;
  std::vector<double> alphas;
  bool all_optimal = true;

  void add(const RunRecord& run) {
    if (run.wall_time_s) times.push_back(*run.wall_time_s);
    if (run.wall_time_s && run.delaunay_time_s) over_delaunay.push_back(*run.wall_time_s / *run.delaunay_time_s);
    if (run.peak_rss_bytes) peaks.push_back(static_cast<double>(*run.peak_rss_bytes));
    // Against a mere lower bound, alpha would depend more on the bound than on the algorithm.
    if (!run.alpha_upper || run.optimality != "proved") return;
    alphas.push_back(*run.alpha_upper);
    all_optimal = all_optimal && run.optimal == "yes";
  }
};

struct Collected {
  Cell cell;
  std::map<std::uint64_t, Observed> by_seed;  // generator, parameters and n being equal, the seed is the instance

  void add(const RunRecord& run) {
    if (run.status == RunStatus::not_applicable) {
      ++cell.not_applicable;
      return;
    }
    ++cell.runs;
    if (is_failure(run.status)) ++cell.failures;
    if (run.status != RunStatus::ok) return;
    if (run.stopped_early.value_or(false)) ++cell.stopped_early;
    by_seed[run.seed].add(run);
  }

  [[nodiscard]] Cell finished() const {
    Cell result = cell;
    result.instances = by_seed.size();
    result.times = observations(&Observed::times);
    result.over_delaunay = observations(&Observed::over_delaunay);
    result.peak_rss_bytes = observations(&Observed::peaks);
    for (const auto& [seed, observed] : by_seed) {
      if (observed.alphas.empty()) continue;
      result.alphas.push_back(median(observed.alphas));
      result.max_alpha = std::max(result.max_alpha, quantile(observed.alphas, 1));
      if (observed.all_optimal) ++result.optimal;
    }
    return result;
  }

  [[nodiscard]] std::vector<double> observations(std::vector<double> Observed::*values) const {
    if (by_seed.size() == 1) return by_seed.begin()->second.*values;
    std::vector<double> medians;
    for (const auto& [seed, observed] : by_seed) {
      if (!(observed.*values).empty()) medians.push_back(median(observed.*values));
    }
    return medians;
  }
};

std::size_t registry_position(const std::string& algorithm) {
  const auto all = algorithms();
  const auto entry = std::find_if(all.begin(), all.end(), [&](const auto& info) { return info.name == algorithm; });
  return static_cast<std::size_t>(entry - all.begin());
}

}  // namespace

CellKey CellKey::series() const {
  CellKey key = *this;
  key.n = 0;
  return key;
}

std::vector<Cell> cells_of(const std::vector<RunRecord>& runs) {
  std::map<std::pair<std::string, std::string>, std::size_t> family_positions;
  std::map<std::tuple<std::size_t, std::size_t, CellKey>, Collected> collected;
  for (const RunRecord& run : runs) {
    const CellKey key{run.generator, run.generator_params, run.algorithm, run.params, run.n};
    const auto family = family_positions.try_emplace({key.generator, key.generator_params}, family_positions.size());
    Collected& entry = collected[{family.first->second, registry_position(run.algorithm), key}];
    entry.cell.key = key;
    entry.add(run);
  }
  std::vector<Cell> cells;
  for (const auto& [position, entry] : collected) cells.push_back(entry.finished());
  return cells;
}

}  // namespace mwt
