// Small text helpers that every record, table and message uses, so that they agree.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mwt {

/// `value` with `digits` digits after the point, for tables.
[[nodiscard]] std::string fixed(double value, int digits);

/// A duration for tables and progress lines, in the largest unit that shows about three digits: "12.3 us", "4.56 s",
/// "3:20 min", "1:40 h", "38 days".
[[nodiscard]] std::string readable_duration(double seconds);

/// The current time as "2026-01-31T23:59:59Z".
[[nodiscard]] std::string utc_now();

/// `text` with every line break and control character replaced by a space, and every byte that is no UTF-8 by a
/// question mark: records and messages are one line of text each.
[[nodiscard]] std::string one_line(std::string_view text);

/// The parts of `text` between occurrences of `separator`; one empty part for an empty text.
[[nodiscard]] std::vector<std::string> split(std::string_view text, char separator);

[[nodiscard]] std::string joined(const std::vector<std::string>& words, std::string_view separator = ", ");

/// "1 cell", "3 cells", "0 cells".
[[nodiscard]] std::string counted(std::size_t count, std::string_view what);

/// "patch k=14", or the name alone without parameters: what tables and messages call a configuration.
[[nodiscard]] std::string name_with_parameters(const std::string& name, const std::string& parameters);

/// The first 16 hexadecimal digits of the SHA-256 of `text`: ids of runs and environments.
[[nodiscard]] std::string short_hash(std::string_view text);

/// SHA-256 in hexadecimal.
[[nodiscard]] std::string sha256_of(std::string_view content);

/// SHA-256 in hexadecimal of a file's content, empty if it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::string& path);

}  // namespace mwt
