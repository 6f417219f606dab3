// Divides the instances of a study among shards.
#pragma once

#include <vector>

#include "harness/study/cluster/cluster_folder.h"
#include "harness/study/estimate/estimate.h"
#include "harness/study/plan.h"

namespace mwt {

/// One row per instance, in the plan's order. The longest instances come first, each to the shard that has least to do
/// (of equals the first): no shard takes longer than 4/3 of the best division, by these times (Graham 1969).
/// Precondition: one time per instance. Throws InputError: more shards than instances.
[[nodiscard]] std::vector<ShardRow> balanced_shards(const Plan& plan, const std::vector<InstanceTime>& times,
                                                    std::size_t shards);

/// Likely seconds by shard, the first one at position 0.
[[nodiscard]] std::vector<double> times_of_shards(const std::vector<ShardRow>& rows, std::size_t shards);

}  // namespace mwt
