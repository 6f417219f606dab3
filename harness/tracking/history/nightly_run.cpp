#include "harness/tracking/history/nightly_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "harness/io/text/text.h"
#include "harness/records/profile_folder.h"
#include "harness/tracking/measures.h"

namespace mwt {

namespace {

/// What the runs of a nightly run have in common.
struct NightlyRunKey {
  std::string git_commit;
  std::string environment;
  std::string machine;
  std::string study;
  std::string configuration;

  friend auto operator<=>(const NightlyRunKey&, const NightlyRunKey&) = default;
};

std::string configuration_of(const ResultSet& results, const RunRecord& run) {
  const bool commit_tells = !run.git_commit.ends_with("-dirty") && run.git_commit != "unknown";
  const std::string program = commit_tells ? "" : run.binary_sha256;
  if (results.study_file.empty() && program.empty()) return "";
  return short_hash(results.study_file + '\n' + program);
}

NightlyRunKey key_of(const ResultSet& results, const RunRecord& run) {
  const EnvironmentRecord environment = results.environment_of(run);
  const std::string machine = machine_of(environment);
  const std::string name = machine.empty() ? "unknown" : machine;
  return {run.git_commit, short_hash(fmt::format("{}\n{}", name, environment.jobs)), name, run.study,
          configuration_of(results, run)};
}

void add_values(NightlyRun& nightly_run, const std::vector<const RunRecord*>& runs) {
  std::map<TrackedCell, std::vector<const RunRecord*>> cells;
  for (const RunRecord* run : runs) {
    cells[cell_of(*run)].push_back(run);
    nightly_run.recorded_at = std::max(nightly_run.recorded_at, run->recorded_at);
  }
  for (const auto& [cell, cell_runs] : cells) {
    for (const Measure& measure : measures()) {
      if (const auto value = typical(measure, cell_runs))
        nightly_run.values.push_back({cell, measure.name, value->value, value->runs});
    }
  }
}

void add_functions(NightlyRun& nightly_run, const std::string& folder, const std::vector<const RunRecord*>& runs) {
  std::map<TrackedCell, FunctionCounts> functions_of;
  std::set<TrackedCell> seen;
  for (const RunRecord* run : runs) {
    if (!run->callgrind_instructions || !seen.insert(cell_of(*run)).second) continue;
    TrackedCell all_seeds = cell_of(*run);
    all_seeds.seed = 0;
    for (const auto& [name, count] : read_profile(folder, run->run_id)) functions_of[all_seeds][name] += count;
  }
  for (const auto& [cell, functions] : functions_of) {
    std::uint64_t sum = 0;
    for (const auto& [name, count] : functions) sum += count;
    for (const auto& [name, count] : functions) {
      if (count >= sum / 100) nightly_run.functions.push_back({cell, name, count});
    }
  }
}

}  // namespace

std::vector<NightlyRun> nightly_runs_of(const ResultSet& results) {
  std::map<NightlyRunKey, std::vector<const RunRecord*>> runs_of;
  for (const RunRecord& run : results.runs) runs_of[key_of(results, run)].push_back(&run);
  std::vector<NightlyRun> nightly_runs;
  for (const auto& [key, runs] : runs_of) {
    NightlyRun& nightly_run = nightly_runs.emplace_back(
        NightlyRun{key.git_commit, key.environment, key.machine, key.study, key.configuration, "", {}, {}});
    add_values(nightly_run, runs);
    add_functions(nightly_run, results.folder, runs);
  }
  std::sort(nightly_runs.begin(), nightly_runs.end(), [](const NightlyRun& a, const NightlyRun& b) {
    return std::tie(a.recorded_at, a.git_commit) < std::tie(b.recorded_at, b.git_commit);
  });
  return nightly_runs;
}

}  // namespace mwt
