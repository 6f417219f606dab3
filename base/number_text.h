// Numbers as text: exact on the way in (correctly rounded), shortest round-trip on the way out, whatever the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mwt {

/// The double nearest to a decimal number such as -1, +.5 or 1.11630e+03; infinite if it is beyond the largest double;
/// `inf` and `nan` are numbers, too. Nothing unless the whole text is one number.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// A decimal whole number within the range of `Whole`: leading zeros mean nothing, one plus sign may stand in front;
/// nothing unless the whole text is one. For int, the 32-bit index, and the signed and unsigned 64-bit integers.
template <class Whole>
[[nodiscard]] std::optional<Whole> parse_whole_number(std::string_view text);

/// Appends the shortest decimal number that reads back as exactly `value`.
void append_number(std::string& text, double value);
[[nodiscard]] std::string number_text(double value);

}  // namespace mwt
