// Numbers as they lie in binary files.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mwt {

enum class NumberKind { real, whole, natural };  ///< IEEE 754; two's complement; without sign

/// How numbers of one column are written. Sizes are 1, 2, 4 or 8 bytes; of real numbers 4 or 8.
struct NumberFormat {
  NumberKind kind = NumberKind::real;
  std::size_t size = 8;
  bool is_big_endian = false;
};

/// The first format.size bytes as an unsigned number.
[[nodiscard]] inline std::uint64_t bits_of(std::string_view bytes, const NumberFormat& format) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < format.size; ++i)
    bits = bits << 8 | static_cast<unsigned char>(bytes[format.is_big_endian ? i : format.size - 1 - i]);
  return bits;
}

/// Of a whole number.
[[nodiscard]] inline std::int64_t signed_value(std::uint64_t bits, const NumberFormat& format) {
  const auto unused = static_cast<unsigned>(64 - 8 * format.size);
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

/// The nearest double.
[[nodiscard]] inline double value_of(std::uint64_t bits, const NumberFormat& format) {
  switch (format.kind) {
    case NumberKind::whole: return static_cast<double>(signed_value(bits, format));
    case NumberKind::natural: return static_cast<double>(bits);
    case NumberKind::real: break;
  }
  return format.size == 8 ? std::bit_cast<double>(bits) : std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}

}  // namespace mwt
