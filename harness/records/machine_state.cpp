#include "harness/records/machine_state.h"

#include <algorithm>

#include "harness/io/text/text.h"

namespace mwt {

namespace {

constexpr double kShareOfAnIdleMachine = 0.95;

}  // namespace

MachineState machine_state_of(const std::vector<RunRecord>& runs, const std::vector<EnvironmentRecord>& environments) {
  MachineState state;
  if (!environments.empty()) state.load_before = environments.front().load_1min;
  double wall = 0, cpu = 0;
  for (const RunRecord& run : runs) {
    if (run.status != RunStatus::ok || run.threads != 1 || !run.wall_time_s || !run.cpu_time_s) continue;
    const auto executions = static_cast<double>(run.iterations.value_or(1));
    wall += *run.wall_time_s * executions;
    cpu += *run.cpu_time_s * executions;
  }
  if (wall > 0) state.cpu_share = std::min(1.0, cpu / wall);
  return state;
}

bool was_idle(const MachineState& state) { return state.cpu_share && *state.cpu_share >= kShareOfAnIdleMachine; }

bool was_busy(const MachineState& state) { return state.cpu_share && *state.cpu_share < kShareOfAnIdleMachine; }

std::string load_text(const MachineState& state) {
  const std::string before = state.load_before ? fixed(*state.load_before, 2) + " before the study" : "unknown";
  if (!state.cpu_share) return before;
  return before + ", its runs had the CPU " + fixed(100 * *state.cpu_share, 0) + "% of the time";
}

}  // namespace mwt
