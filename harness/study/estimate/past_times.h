// Times that studies recorded earlier on this machine.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/records/records.h"
#include "harness/study/estimate/time_model.h"

namespace mwt {

/// The records that were used.
struct PastTimes {
  std::size_t runs = 0;
  std::size_t folders = 0;
};

/// Adds the times of all runs and searches for optima that were recorded on the machine `here`, with that many threads,
/// in `folders` or in folders up to two levels below them. Folders without readable records of this schema version are
/// passed over.
PastTimes add_past_times(TimeModel& model, const std::vector<std::string>& folders, const EnvironmentRecord& here,
                         int threads);

}  // namespace mwt
