#include "harness/paper/latex.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "harness/io/text/text.h"

namespace mwt {

std::string latex_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\': result += "\\textbackslash{}"; break;
      case '~': result += "\\textasciitilde{}"; break;
      case '^': result += "\\textasciicircum{}"; break;
      case '_': result += "\\_\\allowbreak{}"; break;
      case '<':
      case '>':
      case '|': result += fmt::format("${}$", c); break;
      case '#':
      case '$':
      case '%':
      case '&':
      case '{':
      case '}': result += '\\'; [[fallthrough]];
      default: result += c;
    }
  }
  return result;
}

std::string latex_number(double value, int digits) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size < 0.9995e-4 || size >= 1e6) {
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    const std::size_t e = text.find('e');
    return fmt::format("${}\\cdot10^{{{}}}$", text.substr(0, e), std::stoi(text.substr(e + 1)));
  }
  // The exponent after rounding: 9.996 has four digits before the point less than it seems.
  const std::string rounded = fmt::format("{:.{}e}", value, digits - 1);
  const int exponent = std::stoi(rounded.substr(rounded.find('e') + 1));
  return fixed(std::stod(rounded), std::max(0, digits - 1 - exponent));
}

std::string LatexTable::text(const std::vector<std::string>& comments) const {
  std::string result;
  for (const std::string& comment : comments) result += "% " + one_line(comment) + '\n';
  result += "\\begin{tabular}{" + columns + "}\n\\toprule\n" + joined(head, " & ") + " \\\\\n\\midrule\n";
  bool is_first = true;
  for (const std::vector<std::string>& row : rows) {
    if (row.size() == 1) {
      if (!is_first) result += "\\addlinespace\n";
      result += fmt::format("\\multicolumn{{{}}}{{@{{}}l}}{{{}}} \\\\\n", head.size(), row.front());
    } else {
      result += joined(row, " & ") + " \\\\\n";
    }
    is_first = false;
  }
  return result + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace mwt
