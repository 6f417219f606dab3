// For tests only: time that passes by looking at the clock, so that a deadline stops work at the same place every time.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "algorithms/deadline.h"

namespace mwt::test {

/// While it lives, every reading of the clock that deadlines are compared with takes a millisecond, from 0 on.
class CountedTime {
 public:
  CountedTime() {
    readings_ = 0;
    deadline_clock = [] { return after(++readings_); };
  }
  ~CountedTime() { deadline_clock = &std::chrono::steady_clock::now; }
  CountedTime(const CountedTime&) = delete;
  CountedTime& operator=(const CountedTime&) = delete;

  [[nodiscard]] static std::int64_t readings() { return readings_; }
  /// The time after so many readings.
  [[nodiscard]] static std::chrono::steady_clock::time_point after(std::int64_t readings) {
    return std::chrono::steady_clock::time_point(std::chrono::milliseconds(readings));
  }

 private:
  static inline std::atomic<std::int64_t> readings_ = 0;
};

}  // namespace mwt::test
