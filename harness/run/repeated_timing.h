// Times work that may be too short to be timed once, on a machine that may be busy.
#pragma once

#include <cstdint>
#include <functional>

namespace mwt {

struct RepeatedTiming {
  double wall_time_s = 0;        ///< of one execution
  double cpu_time_s = 0;         ///< of one execution, all threads of the process together
  std::uint64_t executions = 1;  ///< by which the times were taken
};

/// Times one execution of `work`. If that used less than `min_time_s` of CPU time, it was too short: more follow, each
/// timed by itself and after the branch history of the one before was overwritten (branch_history.h), until they have
/// used min_time_s of CPU time together, or four times that with what lies between them; at least five. The first
/// execution warmed caches and the allocator and does not count; the times are medians of the others, which short
/// interruptions by other programs do not change. Each includes reading the clocks twice, about half a microsecond.
///
/// CPU time decides how often `work` is executed, for on a busy machine the wall time of a single short execution may
/// be anything; work that does not use the CPU is repeated for ten times min_time_s of wall time at most (and at least
/// five times). What `work` throws comes out. Precondition: repeating `work` does the same again.
[[nodiscard]] RepeatedTiming time_repeatedly(const std::function<void()>& work, double min_time_s);

}  // namespace mwt
