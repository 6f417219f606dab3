#include "base/given_number.h"

#include <fmt/core.h>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>

#include "base/error.h"
#include "base/number_text.h"

namespace mwt {

namespace {

template <class Number>
std::string text_of(Number value) {
  if constexpr (std::floating_point<Number>) {
    return number_text(value);
  } else {
    return std::to_string(value);
  }
}

template <class Number>
std::optional<Number> parse(std::string_view text) {
  if constexpr (std::floating_point<Number>) {
    return parse_number(text);
  } else {
    return parse_whole_number<Number>(text);
  }
}

bool has_only_digits(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

// What is wrong with a text that is no number of the range.
template <class Number>
std::string mistake_in(std::string_view text, NumberRange<Number> range) {
  constexpr bool kIsWhole = !std::floating_point<Number>;
  if (text.empty()) return "is empty";
  const std::optional<double> value = parse_number(text);
  if (!value || std::isnan(*value) || (kIsWhole && !has_only_digits(text))) {
    return kIsWhole ? "is not a whole number" : "is not a number";
  }
  const std::optional<Number> number = parse<Number>(text);
  const bool is_below = number ? *number < range.least : *value < 0;
  return is_below ? "is below " + text_of(range.least) : "is above " + text_of(range.most);
}

// "; give a whole number from 1 to 8". Without limits it has no ends, and is empty if `mistake` has named the kind.
template <class Number>
std::string remedy_for(const std::string& mistake, NumberRange<Number> range) {
  using Limits = std::numeric_limits<Number>;
  const std::string kind = std::floating_point<Number> ? "a number" : "a whole number";
  const bool is_limited =
      std::unsigned_integral<Number> || range.least != Limits::lowest() || range.most != Limits::max();
  if (!is_limited) return mistake.ends_with(kind) ? "" : "; give " + kind;
  return fmt::format("; give {} from {} to {}", kind, text_of(range.least), text_of(range.most));
}

}  // namespace

template <class Number>
Number given_number(const std::string& place, std::string_view text, NumberRange<Number> range) {
  const std::optional<Number> number = parse<Number>(text);
  if (number && *number >= range.least && *number <= range.most) return *number;
  const std::string mistake = mistake_in(text, range);
  throw InputError(place + ' ' + mistake + remedy_for(mistake, range));
}

template double given_number(const std::string&, std::string_view, NumberRange<double>);
template int given_number(const std::string&, std::string_view, NumberRange<int>);
template std::uint32_t given_number(const std::string&, std::string_view, NumberRange<std::uint32_t>);
template std::int64_t given_number(const std::string&, std::string_view, NumberRange<std::int64_t>);
template std::uint64_t given_number(const std::string&, std::string_view, NumberRange<std::uint64_t>);

}  // namespace mwt
