// What changed in the history: when, by how much, between which commits.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/tracking/history/series.h"
#include "harness/tracking/measures.h"

namespace mwt {

/// The step of one series.
struct SeriesStep {
  SeriesKey key;
  std::size_t nightly_run = 0;           ///< the first one at the new level
  std::size_t previous_nightly_run = 0;  ///< the last one at the old level
  double before = 0;
  double after = 0;
  double log_error = 0;  ///< standard error of log(after / before); 0 where there is no noise
};

/// Steps of one algorithm that are alike: same study and environment, same aspect, same direction, about the same
/// nightly run.
struct Change {
  std::string study;
  std::string environment;
  std::string algorithm;  ///< with its parameters
  Aspect aspect = Aspect::time;
  bool is_regression = false;
  std::size_t nightly_run = 0;           ///< that of most of the steps, the earlier one of two
  std::size_t previous_nightly_run = 0;  ///< the last one before
  double factor = 1;                     ///< geometric mean of after / before; for failures the mean of after - before
  double lower = 1;                      ///< 95% interval of the factor; both the factor where there is no noise
  double upper = 1;
  std::string function;  ///< of counts: "find_pair +14.0%", the function that changed most; empty if unknown
  std::vector<SeriesStep> steps;
};

struct ChangeOptions {
  double min_change = 0.03;  ///< of times and memory, relatively: smaller steps are not reported
};

/// Times and memory step as in find_steps() (on logarithms), quality and failures as in find_exact_steps(), where
/// relative differences of quality below 1e-9 are none. The interval of a change is as wide as if the noise of its
/// series were the same: what disturbs a nightly run disturbs them together. Counts, of which kComparedCounts
/// (measures.h) are looked at, step by more than kCountThreshold, the last nightly run at once. Times are relative_time
/// where a study has it, else wall_time_s. Steps that are at most two nightly runs apart make one change. Ordered by
/// nightly run, then regressions first, then by name.
[[nodiscard]] std::vector<Change> find_changes(const std::vector<NightlyRun>& nightly_runs,
                                               const ChangeOptions& options = {});

/// "2026-01-31 greedy: time x1.100 (1.081 .. 1.119) on uniform n=100, ... (abc1234..def5678)", one line each.
[[nodiscard]] std::string describe(const Change& change, const std::vector<NightlyRun>& nightly_runs);

}  // namespace mwt
