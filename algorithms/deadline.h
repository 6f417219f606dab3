// When work must stop.
#pragma once

#include <chrono>
#include <optional>

namespace mwt {

/// A moment after which the best so far is wanted; none: as long as it takes.
using Deadline = std::optional<std::chrono::steady_clock::time_point>;

[[nodiscard]] inline bool has_passed(const Deadline& deadline) {
  return deadline && std::chrono::steady_clock::now() >= *deadline;
}

}  // namespace mwt
