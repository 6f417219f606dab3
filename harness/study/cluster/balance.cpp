#include "harness/study/cluster/balance.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "base/error.h"

namespace mwt {

namespace {

double total_of(const InstanceTime& time) { return time.search_s + time.runs_s; }

}  // namespace

std::vector<ShardRow> balanced_shards(const Plan& plan, const std::vector<InstanceTime>& times, std::size_t shards) {
  if (shards > plan.instances.size()) {
    throw InputError(fmt::format("--shards {}: the study has {} instances, and a shard needs at least one", shards,
                                 plan.instances.size()));
  }
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order,
                           [&](std::size_t a, std::size_t b) { return total_of(times[a]) > total_of(times[b]); });
  std::vector<double> load(shards, 0);
  std::vector<ShardRow> rows(times.size());
  for (const std::size_t position : order) {
    const auto least = std::ranges::min_element(load);
    *least += total_of(times[position]);
    const PlannedInstance& instance = plan.instances[position];
    rows[position] = {static_cast<std::size_t>(least - load.begin()) + 1,
                      instance.generator,
                      instance.parameters,
                      instance.n,
                      instance.seed,
                      0,
                      times[position].search_s,
                      times[position].runs_s};
  }
  for (const PlannedRun& run : plan.runs) ++rows[run.instance].runs;
  return rows;
}

std::vector<double> times_of_shards(const std::vector<ShardRow>& rows, std::size_t shards) {
  std::vector<double> times(shards, 0);
  for (const ShardRow& row : rows) times[row.shard - 1] += row.search_s + row.runs_s;
  return times;
}

}  // namespace mwt
