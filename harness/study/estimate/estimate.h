// How long a study will take, estimated before it runs.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "harness/run/catalogue.h"
#include "harness/study/estimate/time_model.h"
#include "harness/study/plan.h"

namespace mwt {

/// Runs of one cell of a plan, or searches for the optimum by one source: what takes time.
struct PlannedWork {
  TimedCell cell;
  const AlgorithmInfo* algorithm = nullptr;
  Parameters parameters;
  bool has_start_file = false;
  std::size_t instance = 0;  ///< position in the plan of one of its instances
  std::size_t count = 0;
  double limit_s = 0;  ///< of one
  bool is_search = false;
};

/// All that the plan starts; runs beyond an algorithm's largest n take no time and are left out. Of searches, the first
/// source for points in general position.
[[nodiscard]] std::vector<PlannedWork> planned_work(const Study& study, const Catalogue& catalogue, const Plan& plan);

/// Seconds, with one run at a time.
struct DurationEstimate {
  struct Part {
    std::size_t count = 0;  ///< runs or searches
    double seconds = 0;
  };

  double likely = 0;
  double low = 0;  ///< it will probably take low .. high
  double high = 0;
  double most = 0;  ///< every run and every search up to its limit
  std::map<TimeBasis, Part> runs;
  Part searches;
};

[[nodiscard]] DurationEstimate estimate_duration(const Study& study, const Plan& plan,
                                                 const std::vector<PlannedWork>& work, const TimeModel& model);

/// Likely seconds that the parts of one instance take.
struct InstanceTime {
  double search_s = 0;  ///< for its optimum
  double runs_s = 0;
};

/// By position in Plan::instances.
[[nodiscard]] std::vector<InstanceTime> estimate_instances(const Study& study, const Catalogue& catalogue,
                                                           const Plan& plan, const TimeModel& model);

/// Runs algorithms on the plan's smaller instances, one execution each in a process of its own, for about `budget_s`
/// seconds, and adds their times: first every algorithm once, then where the estimate is least sure. Returns the number
/// of runs.
std::size_t calibrate(TimeModel& model, const Study& study, const Plan& plan, const std::vector<PlannedWork>& work,
                      double budget_s);

/// Whether the run is started at all.
[[nodiscard]] inline bool is_within_reach(const PlannedRun& run, const Plan& plan) {
  return plan.instances[run.instance].n <= run.max_n;
}

}  // namespace mwt
