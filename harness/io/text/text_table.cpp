#include "harness/io/text/text_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number_text.h"
#include "harness/io/text/cell_text.h"
#include "harness/io/text/text.h"

namespace mwt {

TextTable::TextTable(std::string source, std::string_view text) : lines_(std::move(source), text) {
  if (!read_row()) return;
  if (is_header()) {
    adopt_header();
    return;
  }
  remove_outer_tabs();
  width_ = columns_.size();
  row_is_ready_ = true;
}

bool TextTable::is_header() const {
  const auto can_be_in_header = [](std::string_view cell) {
    return cell.empty() || is_column_name(without_quotes(cell));
  };
  const auto is_filled = [](std::string_view cell) { return !cell.empty(); };
  const auto is_number = [](std::string_view cell) { return parse_number(cell).has_value(); };
  const bool has_names = std::any_of(columns_.begin(), columns_.end(), is_filled);
  if (has_names && std::all_of(columns_.begin(), columns_.end(), can_be_in_header)) return true;
  if (!has_names) fail("the first row is empty; leave it out, or write numbers");
  if (std::any_of(columns_.begin(), columns_.end(), is_number)) return false;
  fail(not_a_number(*std::find_if_not(columns_.begin(), columns_.end(), can_be_in_header)));
}

void TextTable::adopt_header() {
  for (const std::string_view name : columns_) header_.push_back(lower_case(without_quotes(name)));
  header_line_ = lines_.number();
  width_ = columns_.size();
}

std::optional<std::size_t> TextTable::column_named(std::string_view name) const {
  const auto place = std::find(header_.begin(), header_.end(), name);
  if (place == header_.end()) return std::nullopt;
  if (std::find(place + 1, header_.end(), name) != header_.end()) {
    fail_in_header("two columns are called " + shown(name) + "; keep one name");
  }
  return static_cast<std::size_t>(place - header_.begin());
}

bool TextTable::next_row() {
  if (!std::exchange(row_is_ready_, false)) {
    if (!read_row()) return false;
    if (header_.empty()) remove_outer_tabs();
  }
  require_equal_width();
  return true;
}

// The next line that is neither blank nor only a comment.
bool TextTable::read_row() {
  while (lines_.next()) {
    if (splitter_.split(lines_, columns_)) return true;
  }
  return false;
}

// Tabs that indent a line or end it. With a header they are empty cells.
void TextTable::remove_outer_tabs() {
  if (splitter_.separator() != '\t') return;
  while (columns_.size() > 1 && columns_.back().empty()) columns_.pop_back();
  const auto first =
      std::find_if(columns_.begin(), columns_.end(), [](std::string_view cell) { return !cell.empty(); });
  columns_.erase(columns_.begin(), first);
}

void TextTable::require_equal_width() const {
  if (columns_.size() == width_) return;
  fail(fmt::format("{} where {} has {}; give every row the same columns", counted(columns_.size(), "column"),
                   header_.empty() ? "the first row" : "the header", width_));
}

double TextTable::number(std::size_t column) const {
  const std::string_view text = columns_[column];
  const std::optional<double> value = parse_number(text);
  if (text.empty()) {
    const std::string name = header_.empty() ? "" : " (" + header_[column] + ")";
    fail(fmt::format("column {}{} is empty; write a number", column + 1, name));
  }
  if (!value) fail(not_a_number(text));
  if (!std::isfinite(*value)) fail(shown(text) + " is not a finite double; leave the row out or scale the data down");
  return *value;
}

Index TextTable::index(std::size_t column) const {
  const std::string_view text = columns_[column];
  const std::optional<Index> value = parse_whole_number<Index>(text);
  if (!value || *value == kNoIndex) {
    fail(shown(text) + " is not the index of a point; points are numbered 0, 1, 2, ...");
  }
  return *value;
}

}  // namespace mwt
