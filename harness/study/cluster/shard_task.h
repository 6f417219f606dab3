// What the tasks of a study on a cluster do.
#pragma once

#include <cstddef>
#include <ostream>

#include "harness/run/catalogue.h"
#include "harness/study/cluster/cluster_folder.h"
#include "harness/study/merge.h"

namespace mwt {

enum class TaskEnd {
  complete,  ///< nothing of the shard is missing, or none of its optima if only these were asked for
  stopped,   ///< by a signal
  requeued,  ///< stopped before its time limit, and put back into Slurm's queue
  stuck,     ///< stopped before its time limit for the second time without having recorded anything
};

/// Runs what is missing of a shard, in an attempt of its own; progress goes to `out`. SIGUSR1 announces the time limit.
/// Works without Slurm, too. Throws InputError: no such shard, or the study file has changed.
[[nodiscard]] TaskEnd run_shard_task(const ClusterFolder& folder, const Catalogue& catalogue, std::size_t shard,
                                     bool only_optima, std::ostream& out);

/// Joins the last attempts of all shards in the folder's merged/, which appears complete or not at all. Throws
/// InputError as merge_results(), and if a shard has not begun.
[[nodiscard]] MergeOutcome merge_shards(const ClusterFolder& folder, const Catalogue& catalogue);

}  // namespace mwt
