#include "harness/run/machine/proc_file.h"

#include <charconv>
#include <fstream>

namespace mwt {

std::string value_in(const std::string& path, const std::string& key) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (!line.starts_with(key)) continue;
    const std::size_t begin = line.find_first_not_of(" \t:", key.size());
    const std::size_t last = line.find_last_not_of(" \t");
    return begin == std::string::npos ? "" : line.substr(begin, last + 1 - begin);
  }
  return "";
}

std::optional<std::uint64_t> kilobytes_in(const std::string& path, const std::string& key) {
  const std::string value = value_in(path, key);
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc()) return std::nullopt;
  return number;
}

std::string first_line_of(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

}  // namespace mwt
