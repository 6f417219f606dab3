// When work must stop.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>

namespace mwt {

/// When to return the best result found so far; none: the work takes as long as it takes. Whoever started the work may
/// also stop it at any moment, by `interrupt`.
class Deadline : public std::optional<std::chrono::steady_clock::time_point> {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using std::optional<Time>::optional;

  const std::atomic<bool>* interrupt = nullptr;  ///< once this is true, every deadline has passed; null: never

  /// Another time with the same interrupt.
  [[nodiscard]] Deadline moved_to(const Time& time) const {
    Deadline result(time);
    result.interrupt = interrupt;
    return result;
  }
};

/// What deadlines are compared with: the steady clock, except in tests whose time passes by readings, so that they stop
/// work at the same place every time.
inline std::chrono::steady_clock::time_point (*deadline_clock)() = &std::chrono::steady_clock::now;

[[nodiscard]] inline bool is_interrupted(const Deadline& deadline) {
  return deadline.interrupt != nullptr && deadline.interrupt->load(std::memory_order_relaxed);
}

[[nodiscard]] inline bool has_passed(const Deadline& deadline) {
  return is_interrupted(deadline) || (deadline && deadline_clock() >= *deadline);
}

}  // namespace mwt
