// Splitting the lines of a table into cells.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/io/text/text_lines.h"

namespace mwt {

/// Splits at commas, semicolons, tabs or white space, whichever a line has; if it has several, at what separates the
/// first row.
///
/// - `#` starts a comment. Quotes around a cell are taken off, and keep commas, blanks and `#` in it.
/// - A line with tabs is split at every tab, so that an empty cell stays a cell; tabs beside commas or semicolons are
///   blanks.
/// - A first line "sep=;", as spreadsheets write it, names the separator of all lines.
///
/// Throws InputError "source:line: what; remedy": a line with commas and semicolons, a line with commas where the first
/// row has another separator, a quote that is not closed, an error value of a spreadsheet (`#N/A`) that looks like a
/// comment.
class LineSplitter {
 public:
  /// Puts the cells of the current line into `cells`, without white space at their ends; false if the line is blank or
  /// holds only a comment. The cells live as long as the text.
  [[nodiscard]] bool split(const TextLines& lines, std::vector<std::string_view>& cells);

  /// What the last line was split at: a comma, a semicolon, a tab, a blank for runs of white space, or what "sep="
  /// names.
  [[nodiscard]] char separator() const { return separator_; }

 private:
  [[nodiscard]] bool declares_separator(const TextLines& lines);
  [[nodiscard]] char choose_separator(const TextLines& lines, std::string_view line, unsigned char marks) const;
  void require_separator_of_first_row(const TextLines& lines) const;

  std::optional<char> declared_;
  std::optional<char> of_first_row_;
  char separator_ = ' ';
};

}  // namespace mwt
