#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/study/plan.h"

namespace mwt {

namespace {

// Positions of the instances, the small ones first: dealt out in this order, every size is spread over all shards.
std::vector<std::size_t> by_size(const Plan& plan) {
  std::vector<std::size_t> order(plan.instances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return plan.instances[a].n < plan.instances[b].n; });
  return order;
}

// The instances that are marked, with all their runs.
Plan marked_part(const Plan& plan, const std::vector<bool>& is_ours) {
  Plan part;
  part.notes = plan.notes;
  std::vector<std::size_t> new_position(plan.instances.size());
  for (std::size_t i = 0; i < plan.instances.size(); ++i) {
    new_position[i] = part.instances.size();
    if (is_ours[i]) part.instances.push_back(plan.instances[i]);
  }
  for (const PlannedRun& run : plan.runs) {
    if (!is_ours[run.instance]) continue;
    part.runs.push_back(run);
    part.runs.back().instance = new_position[run.instance];
  }
  return part;
}

}  // namespace

std::string Shard::text() const { return count == 1 ? "" : fmt::format("{}/{}", number, count); }

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const bool has_both = slash != std::string::npos;
  const auto number = parse_whole_number<std::size_t>(text.substr(0, slash));
  const auto count = parse_whole_number<std::size_t>(has_both ? text.substr(slash + 1) : "");
  if (!number || !count || *number < 1 || *number > *count) {
    throw InputError("--shard " + text + ": must be i/N with 1 <= i <= N, such as 1/4");
  }
  return {*number, *count};
}

Plan part_of(const Plan& plan, const Shard& shard) {
  const std::vector<std::size_t> order = by_size(plan);
  std::vector<bool> is_ours(plan.instances.size(), false);
  for (std::size_t rank = shard.number - 1; rank < order.size(); rank += shard.count) is_ours[order[rank]] = true;
  return marked_part(plan, is_ours);
}

Plan part_of(const Plan& plan, const std::set<std::string>& labels) {
  std::vector<bool> is_ours;
  for (const PlannedInstance& instance : plan.instances) is_ours.push_back(labels.contains(instance.label()));
  return marked_part(plan, is_ours);
}

}  // namespace mwt
