// Numbers of triangulations in the records: what the claims on them share.
#pragma once

#include <map>
#include <string>

#include "harness/claims/selection.h"

namespace mwt {

/// The runs of brute_force and subset_dp that counted.
[[nodiscard]] Runs counting_runs(const StudyRecords& records);

/// The factor by which the number grows with every point: exp of the slope of log(number) against n, with its interval.
struct GrowthFactor {
  Estimate factor;
  Runs runs;  ///< those fitted
};

/// Per family with at least three sizes of `min_n` points or more, one run per instance.
[[nodiscard]] std::map<std::string, GrowthFactor> growth_factors(const Runs& runs, Index min_n);

/// "4.36 (4.21 to 4.50)".
[[nodiscard]] std::string factor_text(const Estimate& factor);

/// The Catalan number C(k) = (2k)! / (k! (k+1)!), in decimal. Precondition: k <= 35.
[[nodiscard]] std::string catalan_number(unsigned k);

/// Whether every instance of the family is in strictly convex position.
[[nodiscard]] bool is_convex_family(const std::string& family);

}  // namespace mwt
