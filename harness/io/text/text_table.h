// Plain tables of numbers: the common ground of point lists, triangle lists and edge lists.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.h"
#include "harness/io/text/line_splitter.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

/// Reads a table row by row, lines split by geometry/line_splitter.h; blank lines do not count. If all cells of the
/// first row are names (geometry/cell_text.h) or empty, that row is the header. All rows have equally many columns, and
/// as many as the header if there is one. Without a header, tabs at both ends of a line are blanks.
///
/// Throws InputError "source:line: what; remedy": also for a first row without any number that is no header.
class TextTable {
 public:
  /// The text must outlive the table.
  TextTable(std::string source, std::string_view text);

  /// The header's names in lower case, without quotes; empty if there is none.
  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }

  /// The place of a name in the header. Throws InputError if the header has it twice.
  [[nodiscard]] std::optional<std::size_t> column_named(std::string_view name) const;

  /// Goes to the next row of numbers; false at the end.
  bool next_row();

  [[nodiscard]] std::span<const std::string_view> columns() const { return columns_; }

  /// A column of the current row as a finite number, or as an index.
  [[nodiscard]] double number(std::size_t column) const;
  [[nodiscard]] Index index(std::size_t column) const;

  [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }
  [[noreturn]] void fail_in_header(const std::string& what) const { lines_.fail_at(header_line_, what); }
  [[noreturn]] void fail_as_a_whole(const std::string& what) const { lines_.fail_as_a_whole(what); }

 private:
  [[nodiscard]] bool read_row();
  [[nodiscard]] bool is_header() const;
  void adopt_header();
  void remove_outer_tabs();
  void require_equal_width() const;

  TextLines lines_;
  LineSplitter splitter_;
  std::vector<std::string> header_;
  std::size_t header_line_ = 0;
  std::vector<std::string_view> columns_;
  std::size_t width_ = 0;      // columns of every row, 0 before the first
  bool row_is_ready_ = false;  // the first row was read ahead to look for a header
};

}  // namespace mwt
