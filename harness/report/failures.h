// Which runs failed, in few lines.
#pragma once

#include <string>
#include <vector>

#include "harness/records.h"

namespace mwt {

/// One line per algorithm and kind of failure: how many runs, and the first of them with what it said. Empty if no run
/// failed.
[[nodiscard]] std::string failure_table(const std::vector<RunRecord>& runs);

}  // namespace mwt
