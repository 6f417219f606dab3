#include "generators/arguments.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "base/error.h"

namespace mwt {

namespace {

// Shortest text that reads back as the same number.
template <class Number>
std::string to_text(Number value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

template <class Number>
Number require_within(const std::string& family, const Parameters& parameters, const std::string& name, Number value,
                      Number lowest, Number highest) {
  if (value >= lowest && value <= highest) return value;
  throw InputError(fmt::format("{}: parameter {}={} is not between {} and {}", family, name, parameters.text(name),
                               to_text(lowest), to_text(highest)));
}

}  // namespace

void require_size(const std::string& family, Index n, std::uint64_t smallest, std::uint64_t largest) {
  const std::uint64_t nearest = std::clamp<std::uint64_t>(n, smallest, largest);
  if (nearest == n) return;
  throw InputError(fmt::format("{}: has no instance of n={} points; the nearest legal n is {}", family, n, nearest));
}

double real_within(const std::string& family, const Parameters& parameters, const std::string& name, double lowest,
                   double highest) {
  return require_within(family, parameters, name, parameters.real(name), lowest, highest);
}

std::int64_t integer_within(const std::string& family, const Parameters& parameters, const std::string& name,
                            std::int64_t lowest, std::int64_t highest) {
  return require_within(family, parameters, name, parameters.integer(name), lowest, highest);
}

}  // namespace mwt
