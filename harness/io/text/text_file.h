// Reading text files of any origin.
#pragma once

#include <string>

namespace mwt {

/// The content of a text file (`-`: standard input; compressed ones: what is in them) as UTF-8 without byte order
/// marks, every line ended by LF or CRLF. UTF-16 is recognised by its byte order mark and converted; a CR alone, the
/// line end of old systems, becomes LF. Throws InputError as read_file() does, for NUL bytes (which no text has) and
/// for broken UTF-16.
[[nodiscard]] std::string read_text_file(const std::string& path);

/// The same of a content that has been read; `source` names it in messages.
[[nodiscard]] std::string as_plain_text(std::string content, const std::string& source);

}  // namespace mwt
