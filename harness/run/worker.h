// What happens inside the process of one run.
#pragma once

#include <string>

#include "harness/records/records.h"
#include "harness/run/execution.h"

namespace mwt {

/// How times are taken.
struct Timing {
  double min_time_s = 0.005;   ///< CPU time; shorter executions are repeated until they fill it
  bool delaunay_time = false;  ///< whether the Delaunay time is measured too, after everything else
};

/// Executes, judges and fills in status, checker, message and the measures of `record`, whose other fields say what is
/// run. Its rating stays open: certified_lower is what this run alone certifies. Never throws what an algorithm throws:
/// that becomes a status. An execution longer than `kill_after_s` is a timeout although it has ended.
[[nodiscard]] RunRecord run_in_worker(const Request& request, const Instance& instance, RunRecord record,
                                      const Timing& timing, double kill_after_s);

/// The record as it goes through the pipe, and back. An unreadable text gives nothing.
[[nodiscard]] std::string encode(const RunRecord& record);
[[nodiscard]] std::optional<RunRecord> decode(const std::string& text);

}  // namespace mwt
