// Which runs failed, in few lines.
#pragma once

#include <string>
#include <vector>

#include "harness/records.h"

namespace mwt {

/// One line per algorithm with parameters and kind of failure, the commonest first: how many runs, and the first of
/// them with what it said. Failures of one status are of one kind if their messages differ in numbers only. Empty if no
/// run failed.
[[nodiscard]] std::string failure_table(const std::vector<RunRecord>& runs);

}  // namespace mwt
