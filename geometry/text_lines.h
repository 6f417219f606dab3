// The lines of a text file and the columns of a line, with errors that name the place.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mwt {

/// Walks over a text line by line. Line ends are LF or CRLF; a UTF-8 byte order mark at the start is skipped.
/// The text must outlive this object.
class TextLines {
 public:
  /// `source` names the text in messages.
  TextLines(std::string source, std::string_view text);

  /// Goes to the next line; false at the end.
  bool next();

  /// The current line without surrounding white space.
  [[nodiscard]] std::string_view line() const { return line_; }

  /// Throws InputError "source:line: what".
  [[noreturn]] void fail(const std::string& what) const;

  /// Throws InputError "source: what", for what no single line is to blame for.
  [[noreturn]] void fail_as_a_whole(const std::string& what) const;

 private:
  std::string source_;
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

/// Without spaces, tabs and carriage returns at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// ASCII letters in lower case.
[[nodiscard]] std::string lower_case(std::string_view text);

/// Splits at `separator`, trimming each column; ' ' stands for runs of white space.
void split_columns(std::string_view line, char separator, std::vector<std::string_view>& columns);

/// The text in quotes, fit for a message of one line: long ones are cut, control characters replaced.
[[nodiscard]] std::string shown(std::string_view text);

}  // namespace mwt
