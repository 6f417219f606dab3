// Characters of texts in UTF-8.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mwt {

struct Character {
  char32_t code_point = 0;
  std::size_t size = 0;  ///< in bytes
};

/// The character that `text` begins with; nothing if that is no valid UTF-8, or if there is no text.
[[nodiscard]] std::optional<Character> first_character(std::string_view text);

/// Appends a character. Precondition: a valid code point.
void append_character(std::string& text, char32_t code_point);

/// Whether it is a letter: exact for Latin, Greek and Cyrillic, roughly right for other alphabets.
[[nodiscard]] bool is_letter(char32_t code_point);

/// "U+2212".
[[nodiscard]] std::string code_point_name(char32_t code_point);

}  // namespace mwt
