// The tables that a study prints when it is done.
#pragma once

#include <string>
#include <vector>

#include "harness/records.h"

namespace mwt {

/// First one line per algorithm: runs, failures, alpha over all its rated runs, those with a proved optimum. Then one
/// line per (family, algorithm, n): runs, failures, median time, alpha mean and max, share proved optimal. Runs that
/// are not_applicable count nowhere but in the first table's column of that name. Alphas shown are upper ends of
/// certified intervals, so that none is better than it looks; "-" where no run has a certified bound.
[[nodiscard]] std::string summary_tables(const std::vector<RunRecord>& runs);

/// The middle one, or the mean of the middle two. Precondition: not empty.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace mwt
