#include "harness/report/machines.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "harness/io/text/text.h"
#include "harness/records/environment.h"
#include "harness/records/machine_state.h"

namespace mwt {

namespace {

std::string name_of(const EnvironmentRecord& environment) {
  const std::string machine = machine_of(environment);
  const std::string name = machine.empty() ? "an unknown machine" : machine;
  return environment.jobs == 1 ? name : fmt::format("{}, {} runs side by side", name, environment.jobs);
}

std::string list_of(const std::map<std::string, std::size_t>& runs) {
  std::vector<std::string> parts;
  for (const auto& [name, count] : runs) parts.push_back(fmt::format("{} ({} successful runs)", name, count));
  return joined(parts, "; ");
}

void empty_times(RunRecord& run) {
  run.wall_time_s.reset();
  run.cpu_time_s.reset();
  run.delaunay_time_s.reset();
}

class Machines {
 public:
  explicit Machines(const StudyRecords& records) {
    for (const EnvironmentRecord& environment : records.environments) names_[environment.env_id] = name_of(environment);
  }

  [[nodiscard]] std::string of(const RunRecord& run) const {
    const auto found = names_.find(run.env_id);
    return found == names_.end() ? name_of({}) : found->second;
  }

 private:
  std::map<std::string, std::string> names_;
};

using Counts = std::map<std::string, std::size_t>;  // successful runs

std::string max_frequent(const Counts& counts) {
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace

std::vector<std::string> keep_times_of_one_machine(StudyRecords& records) {
  const Machines machines(records);
  Counts on_machine, by_build;
  for (const RunRecord& run : records.runs) {
    if (run.status == RunStatus::ok) ++on_machine[machines.of(run)];
  }
  if (on_machine.empty()) return {};
  const std::string chosen = max_frequent(on_machine);
  for (RunRecord& run : records.runs) {
    if (machines.of(run) != chosen) {
      empty_times(run);
    } else if (run.status == RunStatus::ok) {
      ++by_build["commit " + run.git_commit + ", program " + run.binary_sha256.substr(0, 10)];
    }
  }
  std::vector<std::string> warnings;
  if (on_machine.size() > 1) {
    warnings.push_back(fmt::format("runs of {} machines: {}; all times here are those of {} alone", on_machine.size(),
                                   list_of(on_machine), chosen));
  }
  if (by_build.size() > 1) {
    warnings.push_back(fmt::format("runs of {} builds of mwt, whose times are taken together: {}", by_build.size(),
                                   list_of(by_build)));
  }
  const MachineState state = machine_state_of(records.runs, {});
  if (was_busy(state)) {
    warnings.push_back("the machine was busy with other programs: the runs had the CPU " +
                       fixed(100 * *state.cpu_share, 0) + "% of the time; wall times are longer than on an idle one");
  }
  return warnings;
}

}  // namespace mwt
