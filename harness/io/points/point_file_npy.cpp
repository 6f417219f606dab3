// NumPy's format for one array, versions 1 to 3 (numpy.lib.format): n rows of two numbers.
#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <optional>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/points/binary_number.h"
#include "harness/io/points/point_formats.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

// What the header states.
struct Layout {
  NumberFormat format;
  bool is_by_column = false;
  std::size_t rows = 0;
  std::size_t data_at = 0;
};

class Header {
 public:
  Header(const std::string& source, std::string_view content) : source_(source), content_(content) {}

  [[nodiscard]] Layout read() {
    constexpr std::size_t kVersionAt = 6, kLengthAt = 8;
    if (content_.size() < 12) fail("is cut off");
    const std::size_t bytes_of_length = content_[kVersionAt] == 1 ? 2 : 4;
    std::size_t length = 0;
    for (std::size_t i = bytes_of_length; i-- > 0;)
      length = length << 8 | static_cast<unsigned char>(content_[kLengthAt + i]);
    layout_.data_at = kLengthAt + bytes_of_length + length;
    if (layout_.data_at > content_.size()) fail("is cut off");
    header_ = content_.substr(kLengthAt + bytes_of_length, length);
    read_type(text_of("descr"));
    layout_.is_by_column = value_of("fortran_order").starts_with("True");
    read_shape(value_of("shape"));
    return layout_;
  }

 private:
  // The header is a Python literal: {'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }.
  [[nodiscard]] std::string_view value_of(std::string_view key) const {
    const std::size_t at = header_.find(fmt::format("'{}'", key));
    const std::size_t colon = at == std::string_view::npos ? at : header_.find(':', at);
    if (colon == std::string_view::npos) fail(fmt::format("its header has no '{}'", key));
    return trimmed(header_.substr(colon + 1));
  }

  [[nodiscard]] std::string_view text_of(std::string_view key) const {
    const std::string_view value = value_of(key);
    const std::size_t end = value.size() > 1 ? value.find('\'', 1) : std::string_view::npos;
    if (!value.starts_with('\'') || end == std::string_view::npos) fail("holds records; save an array of numbers");
    return value.substr(1, end - 1);
  }

  void read_type(std::string_view type) {
    const auto size = type.size() >= 3 ? parse_whole_number<std::size_t>(type.substr(2)) : std::nullopt;
    const bool is_known =
        size && std::string_view("<>|=").find(type[0]) != std::string_view::npos &&
        (type[1] == 'f' ? *size == 4 || *size == 8
                        : (type[1] == 'i' || type[1] == 'u') && (*size == 1 || *size == 2 || *size == 4 || *size == 8));
    if (!is_known) fail("holds numbers of the type " + shown(type) + "; save float64, float32 or integers");
    layout_.format = {type[1] == 'f'   ? NumberKind::real
                      : type[1] == 'i' ? NumberKind::whole
                                       : NumberKind::natural,
                      *size, type[0] == '>'};
  }

  void read_shape(std::string_view value) {
    const std::size_t end = value.find(')');
    if (!value.starts_with('(') || end == std::string_view::npos) fail("its header has no shape");
    std::vector<std::string_view> parts;
    split_columns(value.substr(1, end - 1), ',', parts);
    const auto rows = parts.size() == 2 ? parse_whole_number<std::size_t>(parts[0]) : std::nullopt;
    if (!rows || parts[1] != "2")
      fail("its shape is " + shown(value.substr(0, end + 1)) + "; save an array of shape (n, 2)");
    if (*rows >= kNoIndex || (content_.size() - layout_.data_at) / (2 * layout_.format.size) < *rows)
      fail("is cut off");
    if (content_.size() - layout_.data_at != *rows * 2 * layout_.format.size)
      fail("has more data than its shape states");
    layout_.rows = *rows;
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(source_ + ": this NumPy file " + what); }

  const std::string& source_;
  std::string_view content_;
  std::string_view header_;
  Layout layout_;
};

// Integers must be exact as doubles.
double number_at(std::string_view bytes, const NumberFormat& format, const std::string& source, std::size_t row) {
  const std::uint64_t bits = bits_of(bytes, format);
  const double value = value_of(bits, format);
  if (!std::isfinite(value))
    throw InputError(fmt::format("{}: row {} has a coordinate that is not finite", source, row));
  const bool is_negative = format.kind == NumberKind::whole && signed_value(bits, format) < 0;
  const std::uint64_t magnitude = is_negative ? 0 - static_cast<std::uint64_t>(signed_value(bits, format)) : bits;
  constexpr std::uint64_t kExact = std::uint64_t{1} << 53;
  if (format.kind != NumberKind::real && magnitude > kExact)
    throw InputError(fmt::format("{}: row {} has an integer beyond 2^53, which no double has exactly", source, row));
  return value;
}

}  // namespace

bool looks_like_npy(std::string_view content) { return content.starts_with("\x93NUMPY"); }

std::vector<Point> parse_npy_points(const std::string& source, std::string_view content) {
  const Layout layout = Header(source, content).read();
  const std::string_view data = content.substr(layout.data_at);
  const std::size_t step = layout.format.size;
  std::vector<Point> points;
  points.reserve(layout.rows);
  for (std::size_t row = 0; row < layout.rows; ++row) {
    const std::size_t x = layout.is_by_column ? row : 2 * row;
    const std::size_t y = layout.is_by_column ? layout.rows + row : 2 * row + 1;
    points.push_back({number_at(data.substr(x * step), layout.format, source, row),
                      number_at(data.substr(y * step), layout.format, source, row)});
  }
  if (points.empty()) throw InputError(source + ": this NumPy file has no rows");
  return points;
}

}  // namespace mwt
