#include "harness/io/text/aligned_table.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace mwt {

namespace {

// Characters rather than bytes: continuation bytes of UTF-8 take no room.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

constexpr std::size_t kGap = 2;  // blanks between columns

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// The pieces of a text that may stand in lines of their own: words, and parts of words that end with a hyphen. The
// blank before a word belongs to it.
std::vector<std::string> pieces_of(const std::string& text) {
  std::vector<std::string> pieces(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool after_hyphen = i >= 2 && text[i - 1] == '-' && is_letter(text[i - 2]) && is_letter(text[i]);
    if ((text[i] == ' ' && !pieces.back().empty()) || after_hyphen) pieces.emplace_back();
    pieces.back() += text[i];
  }
  return pieces;
}

std::string without_leading_blanks(const std::string& text) {
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

std::size_t longest_word(const std::string& text) {
  std::size_t longest = 0;
  for (const std::string& piece : pieces_of(text)) longest = std::max(longest, width_of(without_leading_blanks(piece)));
  return longest;
}

// The first `width` characters of a text.
std::string first_characters(const std::string& text, std::size_t width) {
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size(); ++end) {
    const bool begins_character = (static_cast<unsigned char>(text[end]) & 0xc0) != 0x80;
    if (begins_character && ++count > width) break;
  }
  return text.substr(0, end);
}

// The text in lines of at most `width` characters.
std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  if (width_of(text) <= width) return {text};
  std::vector<std::string> lines(1);
  for (const std::string& piece : pieces_of(text)) {
    if (!lines.back().empty() && width_of(lines.back()) + width_of(piece) > width) lines.emplace_back();
    lines.back() += lines.back().empty() ? without_leading_blanks(piece) : piece;
    while (width_of(lines.back()) > width) {
      const std::string head = first_characters(lines.back(), width);
      const std::string tail = lines.back().substr(head.size());
      lines.back() = head;
      lines.push_back(tail);
    }
  }
  return lines;
}

}  // namespace

AlignedTable::AlignedTable(std::vector<std::string> header, const std::vector<std::size_t>& left_aligned)
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
  const std::vector<std::size_t> widths = natural_widths();
  std::string result;
  for (const auto& row : rows_) {
    result += indent;
    append_row(result, row, widths);
  }
  return result;
}

std::string AlignedTable::text_within(std::optional<std::size_t> width) const {
  if (!width) return text();
  const std::vector<std::size_t> widths = widths_within(*width);
  std::string result;
  for (const auto& row : rows_) {
    std::vector<std::vector<std::string>> columns;
    std::size_t height = 1;
    for (std::size_t i = 0; i < row.size(); ++i) {
      columns.push_back(wrapped(row[i], widths[i]));
      height = std::max(height, columns.back().size());
    }
    for (std::size_t line = 0; line < height; ++line) {
      std::vector<std::string> cells;
      for (const auto& lines : columns) cells.push_back(line < lines.size() ? lines[line] : "");
      append_row(result, cells, widths);
    }
  }
  return result;
}

std::vector<std::size_t> AlignedTable::natural_widths() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  return widths;
}

// Takes from the widest column that can give, down to its longest word, and then even below that.
std::vector<std::size_t> AlignedTable::widths_within(std::size_t width) const {
  std::vector<std::size_t> widths = natural_widths();
  std::vector<std::size_t> longest_words = widths, smallest = widths;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (!is_left_aligned_[i]) continue;
    longest_words[i] = smallest[i] = 1;
    for (const auto& row : rows_) longest_words[i] = std::max(longest_words[i], longest_word(row[i]));
  }
  std::size_t total = kGap * (widths.size() - 1) + std::accumulate(widths.begin(), widths.end(), std::size_t{0});
  for (const auto& floor : {longest_words, smallest}) {
    while (total > width) {
      std::size_t widest = widths.size();
      for (std::size_t i = 0; i < widths.size(); ++i) {
        if (widths[i] > floor[i] && (widest == widths.size() || widths[i] > widths[widest])) widest = i;
      }
      if (widest == widths.size()) break;
      --widths[widest];
      --total;
    }
  }
  return widths;
}

void AlignedTable::append_row(std::string& text, const std::vector<std::string>& cells,
                              const std::vector<std::size_t>& widths) const {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t blanks = widths[i] - std::min(widths[i], width_of(cells[i]));
    line.append(i == 0 ? 0 : kGap, ' ');
    if (!is_left_aligned_[i]) line.append(blanks, ' ');
    line += cells[i];
    if (is_left_aligned_[i]) line.append(blanks, ' ');
  }
  line.erase(line.find_last_not_of(' ') + 1);
  text += line + '\n';
}

}  // namespace mwt
