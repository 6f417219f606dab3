// Which runs failed, and which did less than their algorithm promises, in few lines.
#pragma once

#include <string>
#include <vector>

#include "harness/records/records.h"

namespace mwt {

/// One line per algorithm with parameters and kind of failure, the commonest first: how many runs, and the first of
/// them with its message. Failures of one status are of one kind if their messages differ in numbers only. Empty if no
/// run failed.
[[nodiscard]] std::string failure_table(const std::vector<RunRecord>& runs);

/// One line per algorithm and reason for stopping early: how many runs, and the first of them. Empty if none did.
[[nodiscard]] std::string stopped_early_table(const std::vector<RunRecord>& runs);

}  // namespace mwt
