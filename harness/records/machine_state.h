// How busy a machine was while a study ran on it, computed from its records.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/records/records.h"

namespace mwt {

struct MachineState {
  std::optional<double> load_before;  ///< load average when the study began
  std::optional<double> cpu_share;    ///< of the time that runs of one thread took, the share that they had a CPU
};

[[nodiscard]] MachineState machine_state_of(const std::vector<RunRecord>& runs,
                                            const std::vector<EnvironmentRecord>& environments);

/// Whether the runs had a CPU for at least 95% of their time, or surely for less. Both are false without CPU times.
[[nodiscard]] bool was_idle(const MachineState& state);
[[nodiscard]] bool was_busy(const MachineState& state);

/// "0.14 before the study, its runs had the CPU 99% of the time".
[[nodiscard]] std::string load_text(const MachineState& state);

}  // namespace mwt
