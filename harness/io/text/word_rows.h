// Lines of words, as many programs write their meshes: separated by blanks, with comments behind #.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "harness/io/text/text_lines.h"

namespace mwt {

/// Walks over the lines that have words. Everything that reads a word throws InputError "source:line: what" if there is
/// none at that place, or none of that kind. The text must outlive this object.
class WordRows {
 public:
  WordRows(const std::string& source, std::string_view text) : lines_(source, text) {}

  /// Goes to the next line with words; false at the end.
  [[nodiscard]] bool next();

  /// The same where there must be one: "source: ends before WHAT" otherwise.
  void require_next(const std::string& what);

  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }

  [[nodiscard]] double number(std::size_t place) const;      ///< finite
  [[nodiscard]] std::size_t count(std::size_t place) const;  ///< below kNoIndex

  [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }
  [[noreturn]] void fail_as_a_whole(const std::string& what) const { lines_.fail_as_a_whole(what); }

 private:
  [[nodiscard]] std::string_view word(std::size_t place) const;

  TextLines lines_;
  std::vector<std::string_view> words_;
};

}  // namespace mwt
