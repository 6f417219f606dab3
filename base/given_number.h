// Numbers that a user gives, in an option, a parameter or a field of a record: one parser, one wording.
#pragma once

#include <string>
#include <string_view>

namespace mwt {

/// Both ends belong to it.
template <class Number>
struct NumberRange {
  Number least;
  Number most;
};

/// The number that `text` is: decimal, nothing before or after it, within the range. For double, int, the 32-bit index,
/// and the signed and unsigned 64-bit integers; NaN and infinity are in no range.
/// Throws InputError "PLACE is not a whole number; give one from 1 to 8": `place` names the place of the text and
/// shows it, as in "--threads 'two'".
template <class Number>
[[nodiscard]] Number given_number(const std::string& place, std::string_view text, NumberRange<Number> range);

}  // namespace mwt
