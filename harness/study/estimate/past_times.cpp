#include "harness/study/estimate/past_times.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include "base/error.h"
#include "harness/io/text/text.h"
#include "harness/rating/quality.h"
#include "harness/records/results_folder.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 2;
constexpr double kNearLimit = 0.9;

std::set<fs::path> results_folders(const std::vector<std::string>& roots) {
  std::set<fs::path> found;
  for (const std::string& root : roots) {
    std::error_code error;
    if (fs::is_regular_file(fs::path(root) / "runs.csv", error)) found.insert(fs::weakly_canonical(root, error));
    fs::recursive_directory_iterator entry(root, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
      if (entry.depth() >= kDeepest) entry.disable_recursion_pending();
      if (entry->path().filename() != "runs.csv") continue;
      found.insert(fs::weakly_canonical(entry->path().parent_path(), error));
    }
  }
  return found;
}

std::set<std::string> environments_here(const StudyRecords& records, const EnvironmentRecord& here) {
  std::set<std::string> ids;
  for (const EnvironmentRecord& environment : records.environments) {
    const bool is_here = environment.cpu_model == here.cpu_model && environment.logical_cpus == here.logical_cpus &&
                         environment.jobs == 1;
    if (is_here) ids.insert(environment.env_id);
  }
  return ids;
}

std::optional<TimeObservation> observed(const RunRecord& run) {
  if (run.status == RunStatus::timeout) return TimeObservation{run.time_limit_s, true, true};
  const std::optional<double> seconds = undisturbed_time_s(run, run.threads);
  if (!seconds) return std::nullopt;
  const bool near_limit = *run.wall_time_s > kNearLimit * run.time_limit_s;
  return TimeObservation{*seconds, near_limit && run.stopped_early.value_or(false), true};
}

// A search runs its first source, and the others only if that proves nothing.
bool is_time_of_its_source(const InstanceRecord& instance) {
  return instance.optimum_time_s && std::isfinite(*instance.optimum_time_s) && instance.optimum_note.empty() &&
         !instance.optimum_source.empty() && instance.optimality == name_of(Optimality::proved);
}

}  // namespace

PastTimes add_past_times(TimeModel& model, const std::vector<std::string>& folders, const EnvironmentRecord& here,
                         int threads) {
  PastTimes past;
  for (const fs::path& folder : results_folders(folders)) {
    StudyRecords records;
    try {
      records = read_records(folder.string());
    } catch (const InputError&) {
      continue;
    }
    const std::set<std::string> environments = environments_here(records, here);
    const std::size_t before = past.runs;
    for (const RunRecord& run : records.runs) {
      const auto observation = observed(run);
      if (!observation || run.threads != threads || !environments.contains(run.env_id)) continue;
      model.add({name_with_parameters(run.algorithm, run.params),
                 name_with_parameters(run.generator, run.generator_params), run.n},
                *observation);
      ++past.runs;
    }
    for (const InstanceRecord& instance : records.instances) {
      if (!is_time_of_its_source(instance) || !environments.contains(instance.env_id)) continue;
      model.add(
          {instance.optimum_source, name_with_parameters(instance.generator, instance.generator_params), instance.n},
          {*instance.optimum_time_s, false, true});
    }
    if (past.runs > before) ++past.folders;
  }
  return past;
}

}  // namespace mwt
