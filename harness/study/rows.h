// The rows of a study's records: what was planned, joined with what came of it.
#pragma once

#include <map>
#include <string>

#include "harness/rating/optimum_search.h"
#include "harness/records/records.h"
#include "harness/study/plan.h"

namespace mwt {

/// What all rows of one `mwt run` share.
struct RowContext {
  const Study& study;
  const EnvironmentRecord& environment;
  std::map<std::string, double> command_starts{};  ///< seconds, by the names of commands (command_starts.h)
  std::string program{};                           ///< a path of mwt, which is run under callgrind
};

/// The row of a run, recorded now. `instance_id` is empty if there was no instance.
[[nodiscard]] RunRecord row_of(const RowContext& context, const PlannedInstance& instance,
                               const std::string& instance_id, const PlannedRun& planned, RatedRun run);

/// The row of an instance whose optimum has been sought, recorded now.
[[nodiscard]] InstanceRecord row_of(const RowContext& context, const PlannedInstance& planned, const Instance& instance,
                                    const FoundOptimum& found);

}  // namespace mwt
