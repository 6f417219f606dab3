#include "harness/study/cluster/shard_task.h"

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <filesystem>

#include "base/error.h"
#include "harness/io/input_file.h"
#include "harness/io/text/text.h"
#include "harness/run/interrupt.h"
#include "harness/study/cluster/slurm.h"
#include "harness/study/run_study.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

constexpr const char* kNothingRecorded = "stopped before its time limit without having recorded anything";

std::optional<std::string> given(const std::string& text) { return text.empty() ? std::nullopt : std::optional(text); }

Study study_of(const ClusterFolder& folder) {
  const ClusterSettings& settings = folder.settings();
  Study study = read_study(settings.study_path, given(settings.instance_folder));
  if (study.file_content == read_file(folder.file("study.toml"))) return study;
  throw InputError(settings.study_path + ": has changed since the study was submitted; restore it from " +
                   folder.file("study.toml") + ", or submit it to another folder");
}

std::size_t row_count(const std::string& attempt) {
  const StudyRecords records = read_records(attempt);
  return records.runs.size() + records.instances.size();
}

std::string end_of_last(const ClusterFolder& folder, std::size_t shard) {
  const std::optional<std::string> attempt = folder.last_attempt(shard);
  return attempt ? end_of_attempt(*attempt).value_or("") : "";
}

// Slurm may announce a limit a minute early: one attempt without a row is no proof that the limit is too short.
TaskEnd go_on_after_limit(const std::string& attempt, bool has_progressed, const std::string& end_before,
                          std::ostream& out) {
  if (!has_progressed && end_before.starts_with(kNothingRecorded)) {
    write_end_of_attempt(attempt, std::string(kNothingRecorded) + ", twice: give it more --time");
    out << "nothing was recorded within the time limit, twice: give it more --time\n";
    return TaskEnd::stuck;
  }
  write_end_of_attempt(attempt, has_progressed ? "stopped before its time limit" : kNothingRecorded);
  if (!requeue_own_task()) return TaskEnd::stopped;
  out << "stopped before the time limit; queued again\n";
  return TaskEnd::requeued;
}

}  // namespace

TaskEnd run_shard_task(const ClusterFolder& folder, const Catalogue& catalogue, std::size_t shard, bool only_optima,
                       std::ostream& out) {
  const ClusterSettings& settings = folder.settings();
  if (shard < 1 || shard > settings.shards) {
    throw InputError(fmt::format("shard {}: must be 1 to {}", shard, settings.shards));
  }
  hold_time_limit_signal();  // until the study runs; planning it takes its time, too
  const Study study = study_of(folder);
  const std::string end_before = end_of_last(folder, shard);
  RunOptions options;
  options.folder = folder.begin_attempt(shard);
  options.resume = true;
  options.cache_folder = given(settings.cache_folder);
  options.shard = {shard, settings.shards};
  options.instances = folder.labels_of(shard);
  options.only_optima = only_optima;
  options.folder_use = FolderUse::owned;
  const std::size_t rows_before = row_count(options.folder);
  StudyOutcome outcome;
  try {
    outcome = run_study(study, catalogue, options, out);
  } catch (const std::exception& error) {
    write_end_of_attempt(options.folder, error.what());
    throw;
  }
  hold_time_limit_signal();
  if (outcome.interrupted && InterruptWatch::requested_before_time_limit()) {
    return go_on_after_limit(options.folder, row_count(options.folder) > rows_before, end_before, out);
  }
  write_end_of_attempt(options.folder, outcome.interrupted ? "stopped by a signal" : "complete");
  return outcome.interrupted ? TaskEnd::stopped : TaskEnd::complete;
}

MergeOutcome merge_shards(const ClusterFolder& folder, const Catalogue& catalogue) {
  const ClusterSettings& settings = folder.settings();
  const std::string target = folder.file("merged");
  if (fs::exists(target)) throw InputError(target + ": the shards are merged already; remove it to merge them again");
  MergeOptions options;
  for (std::size_t shard = 1; shard <= settings.shards; ++shard) {
    const std::optional<std::string> attempt = folder.last_attempt(shard);
    if (!attempt)
      throw InputError(fmt::format("shard {} has not begun; mwt cluster resubmit {}", shard, folder.path()));
    options.folders.push_back(*attempt);
  }
  options.study_path = settings.study_path;
  options.instance_folder = given(settings.instance_folder);
  options.folder_use = FolderUse::owned;
  options.target = folder.file("merged.unfinished");
  fs::remove_all(options.target);  // of a merging job that was killed
  const MergeOutcome outcome = merge_results(options, catalogue);
  fs::rename(options.target, target);
  return outcome;
}

}  // namespace mwt
