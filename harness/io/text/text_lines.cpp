#include "harness/io/text/text_lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/unicode.h"

namespace mwt {

namespace {

bool is_white_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

void split_at_white_space(std::string_view line, std::vector<std::string_view>& columns) {
  const char* place = line.data();
  const char* const end = place + line.size();
  while (true) {
    while (place != end && is_white_space(*place)) ++place;
    if (place == end) return;
    const char* const start = place;
    while (place != end && !is_white_space(*place)) ++place;
    columns.emplace_back(start, static_cast<std::size_t>(place - start));
  }
}

}  // namespace

TextLines::TextLines(std::string source, std::string_view text) : source_(std::move(source)), rest_(text) {}

bool TextLines::next() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  whole_line_ = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++number_;
  return true;
}

void TextLines::fail_at(std::size_t number, const std::string& what) const {
  throw InputError(fmt::format("{}:{}: {}", source_, number, what));
}

void TextLines::fail_as_a_whole(const std::string& what) const { throw InputError(source_ + ": " + what); }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_white_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_white_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

void split_columns(std::string_view line, char separator, std::vector<std::string_view>& columns) {
  columns.clear();
  if (separator == ' ') {
    split_at_white_space(line, columns);
    return;
  }
  while (true) {
    const std::size_t end = std::min(line.find(separator), line.size());
    columns.push_back(trimmed(line.substr(0, end)));
    if (end == line.size()) return;
    line.remove_prefix(end + 1);
  }
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 40;  // characters
  std::string result = "'";
  for (std::size_t shown = 0; !text.empty(); ++shown) {
    if (shown == kLongest) return result + "...'";
    const std::optional<Character> character = first_character(text);
    const bool is_printable = character && character->code_point >= 0x20 && character->code_point != 0x7F;
    const std::size_t size = character ? character->size : 1;
    is_printable ? result += text.substr(0, size) : result += '?';
    text.remove_prefix(size);
  }
  return result + '\'';
}

}  // namespace mwt
