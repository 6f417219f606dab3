#include "harness/aligned_table.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace mwt {

namespace {

// Characters rather than bytes: continuation bytes of UTF-8 take no room.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

AlignedTable::AlignedTable(std::vector<std::string> header, std::vector<std::size_t> left_aligned)
    : is_left_aligned_(header.size(), false) {
  rows_.push_back(std::move(header));
  is_left_aligned_.at(0) = true;
  for (const std::size_t column : left_aligned) is_left_aligned_.at(column) = true;
}

void AlignedTable::add_row(std::vector<std::string> cells) {
  if (cells.size() != rows_.front().size()) throw std::logic_error("AlignedTable: a row of another width");
  rows_.push_back(std::move(cells));
}

std::string AlignedTable::text(const std::string& indent) const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string result;
  for (const auto& row : rows_) {
    std::string line = indent;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - width_of(row[i]), ' ');
      line += (i == 0 ? "" : "  ") + (is_left_aligned_[i] ? row[i] + blanks : blanks + row[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + '\n';
  }
  return result;
}

}  // namespace mwt
