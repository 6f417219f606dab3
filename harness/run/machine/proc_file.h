// Reading single values from the files of /proc and /sys.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace mwt {

/// The rest of the first line of `path` that starts with `key`, without surrounding blanks and colon; empty if none.
[[nodiscard]] std::string value_in(const std::string& path, const std::string& key);

/// The same as a whole number: "VmHWM:   1234 kB" gives 1234.
[[nodiscard]] std::optional<std::uint64_t> kilobytes_in(const std::string& path, const std::string& key);

/// The first line of a file; empty if it cannot be read.
[[nodiscard]] std::string first_line_of(const std::string& path);

}  // namespace mwt
