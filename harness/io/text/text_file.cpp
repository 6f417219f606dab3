#include "harness/io/text/text_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "base/error.h"
#include "base/unicode.h"
#include "harness/io/compression.h"
#include "harness/io/input_file.h"

namespace mwt {

namespace {

constexpr std::string_view kMark = "\xEF\xBB\xBF";
constexpr std::string_view kMarkLittleEndian = "\xFF\xFE";
constexpr std::string_view kMarkBigEndian = "\xFE\xFF";

// A program that adds a mark to a file that has one leaves two.
void remove_marks(std::string& text) {
  std::size_t size = 0;
  while (std::string_view(text).substr(size).starts_with(kMark)) size += kMark.size();
  text.erase(0, size);
}

// The 16-bit units of UTF-16.
class Units {
 public:
  Units(std::string_view bytes, bool is_little_endian) : bytes_(bytes), low_(is_little_endian ? 0 : 1) {}

  [[nodiscard]] std::size_t count() const { return bytes_.size() / 2; }
  [[nodiscard]] char32_t operator[](std::size_t i) const {
    const auto low = static_cast<unsigned char>(bytes_[2 * i + low_]);
    const auto high = static_cast<unsigned char>(bytes_[2 * i + 1 - low_]);
    return static_cast<char32_t>(high << 8 | low);
  }

 private:
  std::string_view bytes_;
  std::size_t low_;
};

bool is_high_surrogate(char32_t unit) { return unit >= 0xD800 && unit <= 0xDBFF; }
bool is_low_surrogate(char32_t unit) { return unit >= 0xDC00 && unit <= 0xDFFF; }

std::string from_utf16(std::string_view bytes, bool is_little_endian, const std::string& source) {
  const Units units(bytes, is_little_endian);
  bool is_broken = bytes.size() % 2 != 0;
  std::string text;
  for (std::size_t i = 0; i < units.count() && !is_broken; ++i) {
    const char32_t unit = units[i];
    if (is_high_surrogate(unit) && i + 1 < units.count() && is_low_surrogate(units[i + 1])) {
      append_character(text, 0x10000 + ((unit - 0xD800) << 10) + (units[++i] - 0xDC00));
    } else {
      is_broken = is_high_surrogate(unit) || is_low_surrogate(unit);
      if (!is_broken) append_character(text, unit);
    }
  }
  if (is_broken) throw InputError(source + ": begins like UTF-16 but is broken; save it as UTF-8");
  return text;
}

void end_lines_with_lf(std::string& text) {
  for (std::size_t place = text.find('\r'); place != std::string::npos; place = text.find('\r', place + 1)) {
    if (place + 1 == text.size() || text[place + 1] != '\n') text[place] = '\n';
  }
}

void refuse_nul(std::string_view text, const std::string& source) {
  const std::size_t place = text.find('\0');
  if (place == std::string_view::npos) return;
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
  throw InputError(fmt::format(
      "{}:{}: has a NUL byte, so it is no text, or UTF-16 without a byte order mark; save it as UTF-8", source, line));
}

}  // namespace

std::string read_text_file(const std::string& path) {
  const std::string source = source_name(path);
  return as_plain_text(decompressed(read_file(path), source), source);
}

std::string as_plain_text(std::string content, const std::string& source) {
  for (const std::string_view mark : {kMarkLittleEndian, kMarkBigEndian}) {
    if (!content.starts_with(mark)) continue;
    content = from_utf16(std::string_view(content).substr(mark.size()), mark == kMarkLittleEndian, source);
    break;
  }
  remove_marks(content);
  refuse_nul(content, source);
  end_lines_with_lf(content);
  return content;
}

}  // namespace mwt
