// How far a study on a cluster is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/study/cluster/cluster_folder.h"
#include "harness/study/cluster/slurm.h"

namespace mwt {

enum class ShardState {
  not_begun,
  begun,  ///< it has records; whether it runs is not known, for Slurm did not answer or never had it
  waiting,
  running,
  done,  ///< all its runs are recorded
  failed,
};

struct ShardStatus {
  std::size_t number = 0;
  ShardState state = ShardState::not_begun;
  bool seeks_optima = false;  ///< the task that waits or runs is that of the optima
  std::size_t instances = 0;
  std::size_t optima = 0;  ///< instances whose optimum has been sought
  std::size_t planned_runs = 0;
  std::size_t runs = 0;
  double left_s = 0;       ///< likely time that it still needs, once it runs
  std::string node;        ///< where it runs or ran
  std::string why;         ///< it waits or failed
  std::string machine;     ///< what it ran on last; empty if nothing
  bool is_live = false;    ///< one of its tasks waits or runs
  bool is_ending = false;  ///< it is being ended

  [[nodiscard]] bool lacks_optima() const { return optima < instances; }
};

struct ClusterStatus {
  std::vector<ShardStatus> shards;
  std::optional<JobRow> merge_job;  ///< the last one
  std::optional<SlurmState> merge_state;
  bool is_merged = false;
  std::vector<std::string> live_jobs;  ///< ids of jobs with tasks that wait or run, in the order of their submission
  std::string warning;                 ///< Slurm does not answer; empty if it does

  [[nodiscard]] bool has_all_runs() const;
};

/// The folder's path as a word of a shell's command line.
[[nodiscard]] std::string shell_word(const std::string& path);

/// Reads all records of the shards.
[[nodiscard]] ClusterStatus status_of(const ClusterFolder& folder);

/// A table with a line per shard, and what to do next, within `width` columns.
[[nodiscard]] std::string status_text(const ClusterFolder& folder, const ClusterStatus& status,
                                      std::optional<std::size_t> width);

}  // namespace mwt
