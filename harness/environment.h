// The machine and the program, as a study records them.
#pragma once

#include <string>
#include <vector>

#include "harness/records.h"

namespace mwt {

/// All fields but study and jobs; what the system does not tell stays empty. env_id is the hash of the rest.
[[nodiscard]] EnvironmentRecord describe_environment(const std::string& study, int jobs);

/// What about the machine makes its times doubtful, one line each: load, a governor other than performance, swap in
/// use.
[[nodiscard]] std::vector<std::string> timing_warnings(const EnvironmentRecord& environment);

}  // namespace mwt
