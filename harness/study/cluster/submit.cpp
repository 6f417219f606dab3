#include "harness/study/cluster/submit.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>
#include <vector>

#include "base/error.h"
#include "harness/io/output_file.h"
#include "harness/io/text/text.h"
#include "harness/rating/optimum_search.h"
#include "harness/records/environment.h"
#include "harness/study/cluster/balance.h"
#include "harness/study/cluster/scripts.h"
#include "harness/study/cluster/status.h"
#include "harness/study/estimate/observed_times.h"
#include "harness/study/plan.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

using Shards = std::vector<std::string>;

// Shards to be submitted.
struct Missing {
  Shards optima;  ///< and then the runs
  Shards runs;    ///< alone
};

// Submits jobs of one folder, and notes each at once.
class Submission {
 public:
  Submission(const ClusterFolder& folder, std::vector<std::string> options, std::ostream& out)
      : folder_(folder), options_(std::move(options)), out_(out) {}

  // `earlier`: jobs that the merging job waits for, too.
  void submit(const Missing& missing, const std::vector<std::string>& earlier) {
    std::vector<std::string> before_merge = earlier;
    if (!missing.optima.empty()) {
      const std::string optima = submit_tasks(JobKind::optima, missing.optima, {});
      before_merge.push_back(submit_tasks(JobKind::runs, missing.optima, {"--dependency=aftercorr:" + optima}));
    }
    if (!missing.runs.empty()) before_merge.push_back(submit_tasks(JobKind::runs, missing.runs, {}));
    std::vector<std::string> options = options_;
    if (!before_merge.empty()) options.push_back("--dependency=afterany:" + joined(before_merge, ":"));
    submit_job(JobKind::merge, {}, options);
  }

  // Cancels what has been submitted by this object.
  void take_back() const {
    if (!submitted_.empty()) cancel_jobs(submitted_);
  }

 private:
  std::string submit_tasks(JobKind kind, const Shards& shards, const std::vector<std::string>& dependency) {
    std::vector<std::string> options = options_;
    options.push_back("--array=" + joined(shards, ","));
    options.insert(options.end(), dependency.begin(), dependency.end());
    return submit_job(kind, shards, options);
  }

  std::string submit_job(JobKind kind, const Shards& shards, const std::vector<std::string>& options) {
    const std::string id = submit_script(options, folder_.file(script_name(kind)));
    submitted_.push_back(id);
    folder_.append({kind, id, joined(shards, ","), utc_now()});
    out_ << fmt::format("submitted: job {}, {}", id, to_text(kind));
    if (!shards.empty()) out_ << " of shards " << joined(shards, ", ");
    out_ << '\n';
    return id;
  }

  const ClusterFolder& folder_;
  std::vector<std::string> options_;  // on sbatch's command line: they override the script's
  std::ostream& out_;
  std::vector<std::string> submitted_;
};

// A copy: the study goes on with the program that it began with, whatever is built meanwhile.
void copy_program(const std::string& target) {
  std::error_code error;
  fs::copy_file("/proc/self/exe", target, error);
  if (error)
    throw InputError(target + ": cannot be written: " + error.message() + "; choose another folder with --out");
}

void require_new_folder(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error) || (fs::is_directory(path, error) && fs::is_empty(path, error))) return;
  throw InputError(
      path +
      ": has something in it already; continue it with mwt cluster resubmit, or choose another folder with --out");
}

std::vector<ShardRow> planned_shards(const Study& study, const Catalogue& catalogue, const SubmitOptions& options,
                                     std::ostream& out) {
  const Plan plan = make_plan(study, catalogue);
  static_cast<void>(balanced_shards(plan, std::vector<InstanceTime>(plan.instances.size()), options.shards));
  for (const std::string& note : plan.notes) out << "note: " << note << '\n';
  const ObservedTimes times = observe_times(study, plan, planned_work(study, catalogue, plan), options.folder,
                                            describe_environment(study.name, 1, ""));
  out << fmt::format("study {}: {} instances, {} runs; times {}\n", study.name, plan.instances.size(), plan.runs.size(),
                     times.text());
  std::vector<ShardRow> rows =
      balanced_shards(plan, estimate_instances(study, catalogue, plan, times.model), options.shards);
  const std::vector<double> seconds = times_of_shards(rows, options.shards);
  const auto [least, most] = std::ranges::minmax(seconds);
  out << fmt::format("{}: each takes about {} to {}\n", counted(options.shards, "shard"), readable_duration(least),
                     readable_duration(most));
  return rows;
}

void submit_or_take_back(Submission& submission, const Missing& missing) {
  try {
    submission.submit(missing, {});
  } catch (const InputError&) {
    submission.take_back();
    throw;
  }
}

// What has just been cancelled counts as running for some seconds more.
ClusterStatus status_when_nothing_ends(const ClusterFolder& folder) {
  constexpr int kLooks = 30;
  constexpr std::chrono::seconds kPause{2};
  ClusterStatus status = status_of(folder);
  for (int look = 0; look < kLooks && std::ranges::any_of(status.shards, &ShardStatus::is_ending); ++look) {
    std::this_thread::sleep_for(kPause);
    status = status_of(folder);
  }
  return status;
}

std::string next_steps(const std::string& folder) {
  return fmt::format("how far it is: mwt cluster status {0}\nto stop it:    mwt cluster cancel {0}\n",
                     shell_word(folder));
}

}  // namespace

void submit_study(const Study& study, const Catalogue& catalogue, const SubmitOptions& options, std::ostream& out) {
  static_cast<void>(optimum_sources_for(catalogue, study.optimum_sources, kNoIndex));  // are they known and exact?
  const std::string path = fs::absolute(options.folder).lexically_normal().string();
  require_new_folder(path);
  static_cast<void>(script_text(JobKind::runs, path, study, options.request));  // a path that Slurm cannot take
  const std::vector<ShardRow> rows = planned_shards(study, catalogue, options, out);
  const auto absolute = [](const std::optional<std::string>& name) {
    return name && !name->empty() ? fs::absolute(*name).lexically_normal().string() : "";
  };
  const ClusterSettings settings{
      study.name,     absolute(options.study_path), absolute(options.instance_folder), absolute(options.cache_folder),
      options.shards, study.seeks_optimum};
  try {
    ClusterFolder::make(path, settings, rows, study.file_content);
    copy_program((fs::path(path) / "mwt").string());
    for (const JobKind kind : {JobKind::optima, JobKind::runs, JobKind::merge}) {
      if (kind == JobKind::optima && !study.seeks_optimum) continue;
      write_file_atomically((fs::path(path) / script_name(kind)).string(),
                            script_text(kind, path, study, options.request));
    }
    if (options.only_writes) {
      out << "written, not submitted: " << path << '\n';
      return;
    }
    const ClusterFolder folder(path);
    Shards all;
    for (std::size_t shard = 1; shard <= options.shards; ++shard) all.push_back(std::to_string(shard));
    Submission submission(folder, {}, out);
    submit_or_take_back(submission, study.seeks_optimum ? Missing{all, {}} : Missing{{}, all});
  } catch (const InputError&) {
    std::error_code ignored;
    fs::remove_all(path, ignored);
    throw;
  }
  out << next_steps(path);
}

void resubmit_study(const ClusterFolder& folder, const SlurmRequest& request, std::ostream& out) {
  const ClusterStatus status = status_when_nothing_ends(folder);
  if (!status.warning.empty()) throw InputError(status.warning);
  if (status.is_merged) {
    out << "nothing is missing; the records are in " << folder.file("merged") << '\n';
    return;
  }
  Missing missing;
  for (const ShardStatus& shard : status.shards) {
    if (shard.is_live || shard.state == ShardState::done) continue;
    const bool needs_optima = folder.settings().seeks_optimum && shard.lacks_optima();
    (needs_optima ? missing.optima : missing.runs).push_back(std::to_string(shard.number));
  }
  std::vector<std::string> live = status.live_jobs;
  if (status.merge_state && status.merge_state->is_live()) {
    if (missing.optima.empty() && missing.runs.empty()) {
      out << "nothing to submit: all that is missing waits or runs\n";
      return;
    }
    cancel_jobs({status.merge_job->job_id});
    std::erase(live, status.merge_job->job_id);
  }
  Submission(folder, request.words(), out).submit(missing, live);
}

void cancel_study(const ClusterFolder& folder, std::ostream& out) {
  const ClusterStatus status = status_of(folder);
  if (!status.warning.empty()) throw InputError(status.warning);
  if (status.live_jobs.empty()) {
    out << "nothing waits or runs\n";
    return;
  }
  cancel_jobs(status.live_jobs);
  out << "cancelled: " << (status.live_jobs.size() == 1 ? "job " : "jobs ") << joined(status.live_jobs)
      << "; what is recorded stays, and mwt cluster resubmit " << shell_word(folder.path()) << " goes on\n";
}

}  // namespace mwt
