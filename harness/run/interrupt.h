// Ctrl-C, SIGTERM and SIGUSR1 as a flag that loops read.
#pragma once

namespace mwt {

/// While one lives, SIGINT, SIGTERM and SIGUSR1 only set a flag. One at a time. Batch systems send SIGUSR1 before a
/// time limit (harness/study/cluster/).
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  [[nodiscard]] static bool requested();

  /// Whether SIGUSR1 requested it first.
  [[nodiscard]] static bool requested_before_time_limit();
};

/// Keeps SIGUSR1 waiting until the next InterruptWatch, or for good.
void hold_time_limit_signal();

}  // namespace mwt
