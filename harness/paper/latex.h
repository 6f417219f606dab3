// Text for LaTeX.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mwt {

/// The text with LaTeX's special characters escaped.
[[nodiscard]] std::string latex_text(std::string_view text);

/// A number to so many significant digits, without an exponent between 1e-4 and 1e6, else as a power of ten in math.
[[nodiscard]] std::string latex_number(double value, int digits = 3);

/// A tabular environment of package booktabs. Cells and heads are LaTeX.
struct LatexTable {
  std::string columns;  ///< such as "lrr"
  std::vector<std::string> head;

  /// A row of one cell is a heading over all columns, and begins a group.
  std::vector<std::vector<std::string>> rows;

  /// `comments` go in front, each as a line of its own.
  [[nodiscard]] std::string text(const std::vector<std::string>& comments) const;
};

}  // namespace mwt
