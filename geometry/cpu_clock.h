// The processor's time, which does not depend on what else the machine does.
#pragma once

#include <ctime>

namespace mwt {

/// Seconds of processor time that this process has used so far, all threads together.
[[nodiscard]] inline double process_cpu_time_s() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace mwt
