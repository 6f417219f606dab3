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

/// Times one execution of `work`. If that used less than `min_time_s` of CPU time, it was too short: more follow, in
/// batches that use a fifth of min_time_s each. The first batch warms caches and the allocator; of the five after it
/// the times are the medians of their means. Short interruptions by other programs spoil one batch or two, not the
/// median.
///
/// CPU time decides how often `work` is executed, for on a busy machine the wall time of a single short execution may
/// be anything; work that does not use the CPU is repeated for ten times min_time_s of wall time at most (and at least
/// five times). What `work` throws comes out. Precondition: repeating `work` does the same again.
[[nodiscard]] RepeatedTiming time_repeatedly(const std::function<void()>& work, double min_time_s);

}  // namespace mwt
