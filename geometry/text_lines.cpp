#include "geometry/text_lines.h"

#include <algorithm>
#include <utility>

#include "geometry/error.h"

namespace mwt {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kWhiteSpace = " \t\r\f\v";

bool is_white_space(char c) { return kWhiteSpace.find(c) != std::string_view::npos; }

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

TextLines::TextLines(std::string source, std::string_view text) : source_(std::move(source)), rest_(text) {
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool TextLines::next() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  line_ = trimmed(rest_.substr(0, end));
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++number_;
  return true;
}

void TextLines::fail(const std::string& what) const {
  throw InputError(source_ + ":" + std::to_string(number_) + ": " + what);
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
  constexpr std::size_t kLongest = 40;
  std::string result = "'";
  for (const char c : text.substr(0, kLongest)) result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return result + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace mwt
