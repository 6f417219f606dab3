// How a run ended: the closed vocabulary of records, tables and exit codes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mwt {

enum class RunStatus {
  ok,              ///< a triangulation that the checker accepts
  timeout,         ///< killed at the time limit plus grace, or by its CPU limit
  out_of_memory,   ///< an allocation failed under the memory limit, or the system killed the process for memory
  crashed,         ///< a signal, or an end without a result
  invalid_output,  ///< the checker rejected the triangulation
  not_applicable,  ///< the algorithm does not take this instance
  error,           ///< it threw, or its certified bounds contradict others
};

[[nodiscard]] std::string_view name_of(RunStatus status);
[[nodiscard]] std::optional<RunStatus> status_of(std::string_view name);

/// Whether the run counts as failed: everything but ok and not_applicable.
[[nodiscard]] inline bool is_failure(RunStatus status) {
  return status != RunStatus::ok && status != RunStatus::not_applicable;
}

}  // namespace mwt
