// How long a study will take, as far as can be told before it runs.
#pragma once

#include <cstddef>

#include "harness/catalogue.h"
#include "harness/study/plan.h"
#include "harness/study/results_folder.h"

namespace mwt {

/// Seconds, with one run at a time.
struct DurationEstimate {
  double least = 0;       ///< every run in no time, its process and its row counted
  double most = 0;        ///< every run and every search for an optimum up to its limit
  double likely = 0;      ///< what runs and searches took that are recorded; of the others nothing
  std::size_t known = 0;  ///< runs of the plan whose cell is among the recorded ones
};

/// `records`: of an earlier, perhaps unfinished run of the study or of a similar one.
[[nodiscard]] DurationEstimate estimate_duration(const Study& study, const Catalogue& catalogue, const Plan& plan,
                                                 const StudyRecords& records);

/// Whether the run is started at all.
[[nodiscard]] inline bool is_within_reach(const PlannedRun& run, const Plan& plan) {
  return plan.instances[run.instance].n <= run.largest_n;
}

}  // namespace mwt
