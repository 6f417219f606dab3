// The machine and the program, as a study records them.
#pragma once

#include <string>
#include <vector>

#include "harness/records/records.h"

namespace mwt {

/// Of a study, or of a shard "i/N" of it. What the system does not report stays empty. env_id is the hash of the rest.
[[nodiscard]] EnvironmentRecord describe_environment(const std::string& study, int jobs, const std::string& shard = "");

/// What makes two machines the same for comparing times: processor, logical CPUs, memory to the gigabyte. Empty if the
/// environment has none of them.
[[nodiscard]] std::string machine_of(const EnvironmentRecord& environment);

/// What about the machine makes its times doubtful, one line each: load, a governor other than performance, turbo,
/// swap in use, runs side by side.
[[nodiscard]] std::vector<std::string> timing_warnings(const EnvironmentRecord& environment);

}  // namespace mwt
