// What can be compared without statistics: quality, failures, memory.
#pragma once

#include <string>
#include <vector>

#include "harness/tracking/cell.h"
#include "harness/tracking/measures.h"

namespace mwt {

struct ExactFinding {
  TrackedCell cell;
  Aspect aspect = Aspect::quality;
  bool is_regression = false;
  std::string text;               ///< "weight 12.5 -> 12.6", "failed runs: none -> 2 of 3 (timeout)"
  bool depends_on_speed = false;  ///< a busy machine may be the reason: time limits were reached
};

/// - Quality: heavier or lighter if the certified intervals of the weights (over all repetitions that were not stopped
///   early) do not meet; stated as alpha where both sides have proved optima. An optimum that every run of the base
///   proved and no new one does is a regression.
/// - Failures: a larger share of failed runs is a regression, a smaller one an improvement; likewise of runs that were
///   stopped early, and of an algorithm that does not take the instance any more.
/// - Memory: a regression if every new run has a larger peak than every run of the base by more than `threshold` and
///   by more than four mebibytes (whether the system gives huge pages, of two each, and which pages of its libraries
///   are resident, varies); an improvement likewise.
///
/// Precondition: both sides have runs, on the same instance.
[[nodiscard]] std::vector<ExactFinding> exact_findings(const TrackedCell& cell,
                                                       const std::vector<const RunRecord*>& base,
                                                       const std::vector<const RunRecord*>& now, double threshold);

}  // namespace mwt
