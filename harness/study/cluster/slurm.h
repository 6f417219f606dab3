// Slurm's programs: submit, query, cancel. Nothing else here depends on how Slurm prints things.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mwt {

/// What Slurm says of a job, or of one task of an array job.
struct SlurmState {
  std::string state;      ///< "PENDING", "RUNNING", "CANCELLED", ...
  std::string reason;     ///< why it is pending; empty if it is not
  std::string node;       ///< empty if it has none
  std::string time_left;  ///< until its limit, as Slurm writes it

  /// It waits, runs, or is about to do either.
  [[nodiscard]] bool is_live() const;
  [[nodiscard]] bool is_pending() const { return state == "PENDING"; }

  /// Its processes are being ended, by themselves or by Slurm.
  [[nodiscard]] bool is_ending() const { return state == "COMPLETING"; }
};

/// By job id and, for tasks of array jobs, the task's number, else 0.
using SlurmStates = std::map<std::pair<std::string, std::size_t>, SlurmState>;

/// What a partition, a node and an account are asked for; every field is an option of sbatch, if it is given.
struct SlurmRequest {
  std::optional<std::string> partition;
  std::optional<std::string> time;
  std::optional<std::string> memory;
  std::optional<std::string> constraint;
  std::optional<std::string> account;
  std::optional<std::string> qos;
  bool exclusive = false;
  std::vector<std::string> others;  ///< "--nice=100"

  /// "--partition=short", ...
  [[nodiscard]] std::vector<std::string> words() const;
};

/// Submits a script with further options before it. Returns the job's id. Throws InputError with what sbatch says.
[[nodiscard]] std::string submit_script(const std::vector<std::string>& options, const std::string& script);

/// The states of these jobs, as far as squeue, or else the accounting, still has them. Throws InputError: Slurm does
/// not answer.
[[nodiscard]] SlurmStates states_of(const std::vector<std::string>& job_ids);

/// Throws InputError with what scancel says.
void cancel_jobs(const std::vector<std::string>& job_ids);

/// Puts the task that this process belongs to back into the queue, and lets Slurm end it; false if this process belongs
/// to none, or Slurm refuses.
[[nodiscard]] bool requeue_own_task();

}  // namespace mwt
