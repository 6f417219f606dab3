// Submits a study to Slurm: array jobs whose tasks are its shards, and a job that merges them.
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "harness/run/catalogue.h"
#include "harness/study/cluster/cluster_folder.h"
#include "harness/study/cluster/slurm.h"
#include "harness/study/study.h"

namespace mwt {

struct SubmitOptions {
  std::string study_path;
  std::optional<std::string> instance_folder;
  std::string folder;                       ///< must not hold anything yet
  std::optional<std::string> cache_folder;  ///< of optima; none: nowhere
  std::size_t shards = 0;
  SlurmRequest request;
  bool only_writes = false;  ///< whether the scripts are written, but not submitted
};

/// Divides the instances among the shards so that all take about equally long, writes the folder with three scripts,
/// and submits these: an array job for the optima, one for the runs, whose tasks begin when the optima of their shard
/// are there, and a job that merges and reports after them. The shards and their times go to `out`.
///
/// Throws InputError for everything that is wrong with study, folder or request: then nothing is submitted, and no
/// folder is left.
void submit_study(const Study& study, const Catalogue& catalogue, const SubmitOptions& options, std::ostream& out);

/// Submits what is missing: shards that lack runs and have no task that waits or runs, and the merging job. Options of
/// `request` override those of the scripts. Throws InputError: Slurm does not answer, or refuses.
void resubmit_study(const ClusterFolder& folder, const SlurmRequest& request, std::ostream& out);

/// Cancels whatever waits or runs; what is recorded stays. Throws InputError: Slurm does not answer.
void cancel_study(const ClusterFolder& folder, std::ostream& out);

}  // namespace mwt
