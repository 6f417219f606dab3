// What a study has certified so far about the optimum of every instance, and what that says about a run.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "geometry/interval.h"
#include "harness/records.h"

namespace mwt {

class KnownOptima {
 public:
  /// Adds certified bounds. False, and nothing changes, if they contradict what is known.
  [[nodiscard]] bool add(const std::string& instance_id, const Interval& bounds);

  [[nodiscard]] std::optional<Interval> of(const std::string& instance_id) const;

  /// Completes a run's row: takes in the bounds that the run certified itself (record.optimum_*) and its weight as an
  /// upper end, then fills in optimum, optimality, alpha and optimal. Rows without a triangulation stay as they are.
  /// A contradiction makes the row an error; returns false then.
  [[nodiscard]] bool rate(RunRecord& record);

 private:
  std::map<std::string, Interval> bounds_;
};

}  // namespace mwt
