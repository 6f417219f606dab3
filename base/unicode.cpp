#include "base/unicode.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mwt {

namespace {

constexpr char32_t kMaxCodePoint = 0x10FFFF;

bool is_surrogate(char32_t code_point) { return code_point >= 0xD800 && code_point <= 0xDFFF; }

// How many bytes the character has whose first byte this is; 0 if none begins so.
std::size_t size_by_first_byte(unsigned char byte) {
  if (byte < 0x80) return 1;
  if (byte >= 0xC2 && byte <= 0xDF) return 2;
  if (byte >= 0xE0 && byte <= 0xEF) return 3;
  if (byte >= 0xF0 && byte <= 0xF4) return 4;
  return 0;
}

// The smallest code point that needs as many bytes; smaller ones written so are invalid.
constexpr std::array<char32_t, 5> kMinOfSize = {0, 0, 0x80, 0x800, 0x10000};

struct Block {
  char32_t first, last;
};

// Blocks of letters, signs and digits within them included where they are rare.
constexpr std::array<Block, 9> kLetters = {{{'A', 'Z'},
                                            {'a', 'z'},
                                            {0xC0, 0xD6},
                                            {0xD8, 0xF6},
                                            {0xF8, 0x24F},
                                            {0x370, 0x5FF},
                                            {0x3040, 0x30FF},
                                            {0x4E00, 0x9FFF},
                                            {0xAC00, 0xD7A3}}};

}  // namespace

std::optional<Character> first_character(std::string_view text) {
  if (text.empty()) return std::nullopt;
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t size = size_by_first_byte(first);
  if (size == 0 || size > text.size()) return std::nullopt;
  char32_t code_point = size == 1 ? first : first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0) != 0x80) return std::nullopt;
    code_point = code_point << 6 | (byte & 0x3FU);
  }
  if (code_point < kMinOfSize[size] || code_point > kMaxCodePoint || is_surrogate(code_point)) {
    return std::nullopt;
  }
  return Character{code_point, size};
}

void append_character(std::string& text, char32_t code_point) {
  const auto continuation = [&](int shift) { text += static_cast<char>(0x80 | (code_point >> shift & 0x3F)); };
  if (code_point < 0x80) {
    text += static_cast<char>(code_point);
  } else if (code_point < 0x800) {
    text += static_cast<char>(0xC0 | code_point >> 6);
    continuation(0);
  } else if (code_point < 0x10000) {
    text += static_cast<char>(0xE0 | code_point >> 12);
    continuation(6);
    continuation(0);
  } else {
    text += static_cast<char>(0xF0 | code_point >> 18);
    continuation(12);
    continuation(6);
    continuation(0);
  }
}

bool is_letter(char32_t code_point) {
  return std::any_of(kLetters.begin(), kLetters.end(), [code_point](const Block& block) {
    return code_point >= block.first && code_point <= block.last;
  });
}

std::string code_point_name(char32_t code_point) { return fmt::format("U+{:04X}", static_cast<unsigned>(code_point)); }

}  // namespace mwt
