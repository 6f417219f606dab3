// The processor's time, which does not depend on what else the machine does.
#pragma once

#include <ctime>

namespace mwt {

/// Seconds of processor time that this process has used so far, all threads together, to the microsecond.
[[nodiscard]] inline double process_cpu_time_s() {
  std::timespec time{};
  // Where a limit of CPU time is set (ulimit -t), Linux updates the process's clock only at ticks of 1 to 10 ms, and
  // when a thread's own clock is read: so it is up to date for the calling thread in any case.
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace mwt
