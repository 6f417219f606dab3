// What a cell of a table is when it is no number: the name of a column, a missing value, or a mistake.
#pragma once

#include <string>
#include <string_view>

namespace mwt {

/// What is wrong with a cell that parse_number() refuses, and the remedy: "'1,5' is not a number; write a decimal point
/// instead of the comma".
[[nodiscard]] std::string not_a_number(std::string_view cell);

/// Whether the cell stands for a value that is missing: `NA`, `N/A`, `null`, `none`, `missing`, `#N/A`, ..., in either
/// case.
[[nodiscard]] bool is_missing_value(std::string_view cell);

/// Whether the cell can be the name of a column: it begins with a letter of any alphabet or an underscore, and is
/// neither a number nor a missing value.
[[nodiscard]] bool is_column_name(std::string_view cell);

/// Whether a column of that name (in lower case) holds labels of the rows, such as id, index or name. A column without
/// a name does.
[[nodiscard]] bool names_row_labels(std::string_view column);

/// Without the quotes around it, if there are any.
[[nodiscard]] std::string_view without_quotes(std::string_view cell);

}  // namespace mwt
