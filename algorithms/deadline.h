// When work must stop.
#pragma once

#include <chrono>
#include <optional>

namespace mwt {

/// When to return the best result found so far; none: the work takes as long as it takes.
using Deadline = std::optional<std::chrono::steady_clock::time_point>;

[[nodiscard]] inline bool has_passed(const Deadline& deadline) {
  return deadline && std::chrono::steady_clock::now() >= *deadline;
}

}  // namespace mwt
