#include "geometry/text_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "geometry/number_text.h"

namespace mwt {

namespace {

std::string_view without_quotes(std::string_view text) {
  if (text.size() >= 2 && text.front() == text.back() && (text.front() == '"' || text.front() == '\'')) {
    return text.substr(1, text.size() - 2);
  }
  return text;
}

// Blanks alone separate "1 2"; with a comma or semicolon anywhere in the line, that is the separator.
char separator_of(std::string_view line, const TextLines& lines) {
  const bool comma = line.find(',') != std::string_view::npos;
  const bool semicolon = line.find(';') != std::string_view::npos;
  if (comma && semicolon) lines.fail("both commas and semicolons; write x,y with decimal points");
  return comma ? ',' : semicolon ? ';' : ' ';
}

}  // namespace

TextTable::TextTable(std::string source, std::string_view text) : lines_(std::move(source), text) {
  if (!read_row()) return;
  const bool has_number = std::any_of(columns_.begin(), columns_.end(),
                                      [](std::string_view column) { return parse_number(column).has_value(); });
  width_ = columns_.size();
  row_is_ready_ = has_number;
  if (has_number) return;
  for (const std::string_view name : columns_) header_.push_back(lower_case(without_quotes(name)));
}

std::optional<std::size_t> TextTable::column_named(std::string_view name) const {
  const auto place = std::find(header_.begin(), header_.end(), name);
  if (place == header_.end()) return std::nullopt;
  return static_cast<std::size_t>(place - header_.begin());
}

bool TextTable::next_row() {
  if (!std::exchange(row_is_ready_, false) && !read_row()) return false;
  require_equal_width();
  return true;
}

// The next line that is neither blank nor only a comment.
bool TextTable::read_row() {
  while (lines_.next()) {
    const std::string_view line = trimmed(lines_.line().substr(0, lines_.line().find('#')));
    if (line.empty()) continue;
    split_columns(line, separator_of(line, lines_), columns_);
    return true;
  }
  return false;
}

void TextTable::require_equal_width() {
  if (columns_.size() == width_) return;
  fail(std::to_string(columns_.size()) + (columns_.size() == 1 ? " column" : " columns") + " where " +
       (header_.empty() ? "the first row has " : "the header has ") + std::to_string(width_) +
       "; give every row the same columns");
}

double TextTable::number(std::size_t column) const {
  const std::string_view text = columns_[column];
  const std::optional<double> value = parse_number(text);
  if (text.empty()) fail("column " + std::to_string(column + 1) + " is empty; write a number");
  if (!value) fail(shown(text) + " is not a number; write one such as 1.5 or 2e-3");
  if (!std::isfinite(*value)) fail(shown(text) + " is not a finite double; leave the row out or scale the data down");
  return *value;
}

Index TextTable::index(std::size_t column) const {
  const std::string_view text = columns_[column];
  Index value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || value == kNoIndex) {
    fail(shown(text) + " is not the index of a point; points are numbered 0, 1, 2, ...");
  }
  return value;
}

}  // namespace mwt
