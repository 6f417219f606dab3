// What can be compared without statistics: quality, failures, memory, counts of instructions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/run/callgrind/profile.h"
#include "harness/tracking/cell.h"
#include "harness/tracking/measures.h"

namespace mwt {

struct ExactFinding {
  TrackedCell cell;
  Aspect aspect = Aspect::quality;
  bool is_regression = false;
  std::string text;               ///< "weight 12.5 -> 12.6", "failed runs: none -> 2 of 3 (timeout)"
  bool depends_on_speed = false;  ///< a busy machine may be the reason: time limits were reached
  bool is_confirmed = true;       ///< by a second run; what is not may be a mistake of the measurement
};

/// The instructions of functions of a run, by its run_id; empty if they are not known. See records/profile_folder.h.
struct Profiles {
  std::function<FunctionCounts(const RunRecord&)> base;
  std::function<FunctionCounts(const RunRecord&)> now;
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
/// - Counts: a regression if every counted run of the new results has more instructions than every one of the base by
///   kCountThreshold (measures.h); an improvement likewise. Confirmed if both sides counted two runs. The text names
///   the function that changed most, by the profiles.
///
/// Precondition: both sides have runs, on the same instance.
[[nodiscard]] std::vector<ExactFinding> exact_findings(const TrackedCell& cell,
                                                       const std::vector<const RunRecord*>& base,
                                                       const std::vector<const RunRecord*>& now, double threshold,
                                                       const Profiles& profiles = {});

}  // namespace mwt
