// Where the history is, for the commands that use it.
#pragma once

#include <optional>
#include <string>

namespace mwt {

inline constexpr const char* kHistoryHelp = "the history's file; results/history.sqlite if not given";

[[nodiscard]] inline std::string history_path(const std::optional<std::string>& given) {
  return given.value_or("results/history.sqlite");
}

/// Makes the folder of `path` if it is missing. Throws InputError if it cannot.
void make_folder_of(const std::string& path);

}  // namespace mwt
