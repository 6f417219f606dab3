// The statistics of comparison.h, on plain numbers.
#pragma once

#include <vector>

#include "harness/statistics/bootstrap.h"

namespace mwt {

/// A ratio of times and how sure it is to lie on either side of the threshold, before any correction for many tests.
struct TimeJudgement {
  Estimate ratio;
  double p_slower = 1;      ///< of "the ratio is at most 1 + threshold"
  double p_faster = 1;      ///< of "the ratio is at least 1 / (1 + threshold)"
  double p_not_slower = 1;  ///< of "the ratio is at least 1 + threshold": small where a slowdown is excluded
  double p_not_faster = 1;  ///< of "the ratio is at most 1 / (1 + threshold)"
};

/// Of observations of the ratio's logarithm that are independent and symmetric about it: Hodges-Lehmann estimate,
/// Wilcoxon's signed-rank test. Precondition: at least one observation.
[[nodiscard]] TimeJudgement judge_log_ratios(const std::vector<double>& log_ratios, double threshold);

/// Of the logarithms of independent times of both sides: Hodges-Lehmann shift, rank-sum test.
/// Precondition: at least one of each.
[[nodiscard]] TimeJudgement judge_log_times(const std::vector<double>& base, const std::vector<double>& now,
                                            double threshold);

/// Makes `judgement` less sure unless its ratio also stands out from those of all cells (its own included), whose
/// spread shows how much a cell differs between two sessions: Student's t with 3 degrees of freedom. So much may also
/// have hidden a slowdown: what is excluded must stand off from the threshold likewise.
void require_standing_out(TimeJudgement& judgement, const std::vector<double>& log_ratios_of_all, double threshold);

/// Makes `judgement` less sure unless `own` log ratios are also slower (or faster) than `others` by more than the
/// threshold.
void require_difference_from_others(TimeJudgement& judgement, const std::vector<double>& own,
                                    const std::vector<double>& others, double threshold);

}  // namespace mwt
