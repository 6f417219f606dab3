// When work must stop.
#pragma once

#include <chrono>
#include <optional>

namespace mwt {

/// When to return the best result found so far; none: the work takes as long as it takes.
using Deadline = std::optional<std::chrono::steady_clock::time_point>;

/// What deadlines are compared with: the steady clock, except in tests whose time passes by readings, so that they stop
/// work at the same place every time.
inline std::chrono::steady_clock::time_point (*deadline_clock)() = &std::chrono::steady_clock::now;

[[nodiscard]] inline bool has_passed(const Deadline& deadline) { return deadline && deadline_clock() >= *deadline; }

}  // namespace mwt
