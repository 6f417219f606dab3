#include "base/number_text.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>

namespace mwt {

namespace {

// std::from_chars takes no plus sign.
std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
  return text;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  text = without_plus(text);
  const char* end = text.data() + text.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return std::nullopt;
  // Beyond the doubles std::from_chars leaves value alone; std::strtod returns infinity or a tiny number.
  if (error == std::errc::result_out_of_range) return std::strtod(std::string(text).c_str(), nullptr);
  return value;
}

template <class Whole>
std::optional<Whole> parse_whole_number(std::string_view text) {
  text = without_plus(text);
  const char* end = text.data() + text.size();
  Whole value = 0;
  const auto [stop, error] = std::from_chars(text.data(), end, value, 10);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

template std::optional<int> parse_whole_number(std::string_view);
template std::optional<std::uint32_t> parse_whole_number(std::string_view);
template std::optional<std::int64_t> parse_whole_number(std::string_view);
template std::optional<std::uint64_t> parse_whole_number(std::string_view);

void append_number(std::string& text, double value) {
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), result.ptr);
}

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

}  // namespace mwt
