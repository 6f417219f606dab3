// The folder of a study that runs on a cluster: what was submitted, and what its shards have recorded.
//
//   cluster.csv, study.toml, mwt      settings, the study file and the program as they were at the submission
//   shards.csv                        one row per instance: its shard, its number of runs, its estimated times
//   jobs.csv                          one row per job that was submitted
//   optima.sbatch, runs.sbatch, merge.sbatch; logs/
//   shards/I/attempt-K/               the records of the K-th attempt at shard I, with those of the attempts before
//   merged/                           the records of all shards, a results folder like any other
//
// Nothing here needs a lock, for network file systems have none to rely on. An attempt has a folder of its own, claimed
// by making it, which succeeds once; only its process writes there. It begins with a copy of what the last attempt had
// recorded. What a process that Slurm lost sight of adds to an earlier attempt changes nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/point.h"

namespace mwt {

struct ClusterSettings {
  std::string study;       ///< its name
  std::string study_path;  ///< absolute; commands and files that the study names count from its folder
  std::string instance_folder;
  std::string cache_folder;  ///< of optima; empty: none
  std::size_t shards = 0;
  bool seeks_optimum = true;
};

/// One instance of the study.
struct ShardRow {
  std::size_t shard = 0;  ///< 1 .. ClusterSettings::shards
  std::string generator;
  std::string generator_params;
  Index n = 0;
  std::uint64_t seed = 0;
  std::size_t runs = 0;
  double search_s = 0;  ///< likely time of the search for its optimum
  double runs_s = 0;    ///< of its runs
};

enum class JobKind { optima, runs, merge };

/// A job that was submitted; with tasks, an array job.
struct JobRow {
  JobKind kind = JobKind::runs;
  std::string job_id;
  std::string shards;  ///< "1,2,5": its tasks
  std::string submitted_at;

  [[nodiscard]] bool has_task(std::size_t shard) const;
};

class ClusterFolder {
 public:
  /// Reads a folder. Throws InputError: none that `mwt cluster submit` wrote.
  explicit ClusterFolder(const std::string& path);

  /// Makes one. Throws InputError: it holds something already, or cannot be written.
  static void make(const std::string& path, const ClusterSettings& settings, const std::vector<ShardRow>& rows,
                   const std::string& study_file);

  [[nodiscard]] const std::string& path() const { return path_; }  ///< absolute
  [[nodiscard]] std::string file(const std::string& name) const;
  [[nodiscard]] const ClusterSettings& settings() const { return settings_; }
  [[nodiscard]] const std::vector<ShardRow>& rows() const { return rows_; }
  [[nodiscard]] std::set<std::string> labels_of(std::size_t shard) const;

  [[nodiscard]] std::vector<JobRow> jobs() const;
  void append(const JobRow& job) const;

  /// The folder of the last attempt that has records.
  [[nodiscard]] std::optional<std::string> last_attempt(std::size_t shard) const;

  /// Claims a folder for the next attempt and copies there what the last one has recorded; returns its path. Throws
  /// InputError: it cannot be written, or the last attempt's records are damaged.
  [[nodiscard]] std::string begin_attempt(std::size_t shard) const;

 private:
  [[nodiscard]] std::string shard_folder(std::size_t shard) const;
  [[nodiscard]] std::vector<std::size_t> attempts(std::size_t shard) const;

  std::string path_;
  ClusterSettings settings_;
  std::vector<ShardRow> rows_;
};

/// How an attempt ended, one line in its folder; nothing while it runs, or if it was killed.
void write_end_of_attempt(const std::string& attempt, const std::string& text);
[[nodiscard]] std::optional<std::string> end_of_attempt(const std::string& attempt);

[[nodiscard]] std::string to_text(JobKind kind);
/// Throws std::invalid_argument.
void read_text(const std::string& text, JobKind& kind);

}  // namespace mwt
