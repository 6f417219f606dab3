// Telling UTF-8 from other bytes: file names and messages of programs may hold anything, records are text.
#pragma once

#include <cstddef>
#include <string_view>

namespace mwt {

/// Bytes of the UTF-8 character at `position`, 1 to 4; 0 if there is none. Surrogates count as characters.
/// Precondition: position < text.size().
[[nodiscard]] std::size_t utf8_length(std::string_view text, std::size_t position);

}  // namespace mwt
