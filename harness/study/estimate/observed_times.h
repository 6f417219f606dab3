// What is known of the times of a study before it runs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/study/estimate/estimate.h"
#include "harness/study/estimate/past_times.h"
#include "harness/study/estimate/time_model.h"

namespace mwt {

struct ObservedTimes {
  TimeModel model;
  PastTimes past;
  std::size_t measured = 0;  ///< runs made just now
  double elapsed_s = 0;      ///< by these

  /// "estimated from 12 recorded runs in 1 folders of this machine and 30 runs made just now in 8.01 s".
  [[nodiscard]] std::string text() const;
};

/// From what studies recorded on the machine `here` in the folder, beside it or in ./results, and from a calibration of
/// some seconds.
[[nodiscard]] ObservedTimes observe_times(const Study& study, const Plan& plan, const std::vector<PlannedWork>& work,
                                          const std::string& folder, const EnvironmentRecord& here);

}  // namespace mwt
