// The lines of a text file and the columns of a line, with errors that name the place.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mwt {

/// Without white space at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Walks over a text line by line. Line ends are LF or CRLF. The text must outlive this object.
class TextLines {
 public:
  /// `source` names the text in messages.
  TextLines(std::string source, std::string_view text);

  /// Goes to the next line; false at the end.
  bool next();

  /// The current line without surrounding white space, and with it.
  [[nodiscard]] std::string_view line() const { return trimmed(whole_line_); }
  [[nodiscard]] std::string_view whole_line() const { return whole_line_; }

  /// Of the current line, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }

  /// Throws InputError "source:line: what".
  [[noreturn]] void fail(const std::string& what) const { fail_at(number_, what); }
  [[noreturn]] void fail_at(std::size_t number, const std::string& what) const;

  /// Throws InputError "source: what", for what no single line is to blame for.
  [[noreturn]] void fail_as_a_whole(const std::string& what) const;

 private:
  std::string source_;
  std::string_view rest_;
  std::string_view whole_line_;
  std::size_t number_ = 0;
};

/// ASCII letters in lower case.
[[nodiscard]] std::string lower_case(std::string_view text);

/// Splits at `separator`, trimming each column; ' ' stands for runs of white space.
void split_columns(std::string_view line, char separator, std::vector<std::string_view>& columns);

/// The text in quotes, fit for a message of one line: long ones are cut, control characters and bytes that are no UTF-8
/// replaced.
[[nodiscard]] std::string shown(std::string_view text);

}  // namespace mwt
