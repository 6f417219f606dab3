// Why an algorithm ended before its work was done: the closed vocabulary of solutions, records and reports.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

namespace mwt {

/// What stopped an algorithm that returned less than it promises. The triangulation is valid whatever the reason.
/// Ascending: the later ones depend more on the machine and on its load, and the results with them.
enum class StopReason {
  precision,  ///< rounding left certified bounds apart; more time does not help
  size,       ///< a part of the problem exceeds a limit of the algorithm's own, which its header states
  memory,     ///< there was too little memory
  deadline,   ///< the caller's time limit
};

/// "precision", "size", "memory", "deadline".
[[nodiscard]] std::string_view name_of(StopReason reason);
/// The reason of that name, if there is one.
[[nodiscard]] std::optional<StopReason> stop_reason_of(std::string_view name);
/// For people, to follow "stopped early: ", such as "at the time limit".
[[nodiscard]] std::string_view phrase_of(StopReason reason);

/// The reason of work in two parts: where both stopped early, the one that depends more on the machine.
[[nodiscard]] inline std::optional<StopReason> combined(std::optional<StopReason> one,
                                                        std::optional<StopReason> other) {
  return std::max(one, other);  // nothing is less than any reason
}

/// The reason of a search that only the deadline can stop.
[[nodiscard]] inline std::optional<StopReason> deadline_if(bool stopped) {
  return stopped ? std::optional(StopReason::deadline) : std::nullopt;
}

}  // namespace mwt
