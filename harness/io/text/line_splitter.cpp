#include "harness/io/text/line_splitter.h"

#include "harness/io/text/cell_text.h"

namespace mwt {

namespace {

// The characters that matter to splitting, as bits.
constexpr unsigned char kComma = 1, kSemicolon = 2, kTab = 4, kQuote = 8, kComment = 16;

constexpr unsigned char mark_of(char c) {
  return static_cast<unsigned char>((c == ',' ? kComma : 0) | (c == ';' ? kSemicolon : 0) | (c == '\t' ? kTab : 0) |
                                    (c == '"' ? kQuote : 0) | (c == '#' ? kComment : 0));
}

// Without branches, so that the compiler looks at many characters at once.
unsigned char marks_in(std::string_view line) {
  unsigned char marks = 0;
  for (const char c : line) marks |= mark_of(c);
  return marks;
}

std::string_view name_of(char separator) {
  switch (separator) {
    case ',': return "commas";
    case ';': return "semicolons";
    case '\t': return "tabs";
    default: return "blanks";
  }
}

// The line with a harmless letter for every character within quotes. A quote opens at the start of a cell only.
std::string with_quoted_parts_masked(const TextLines& lines) {
  std::string masked(lines.whole_line());
  bool in_quotes = false, at_start = true;
  for (std::size_t i = 0; i < masked.size(); ++i) {
    const char c = masked[i];
    const bool is_doubled = in_quotes && c == '"' && i + 1 < masked.size() && masked[i + 1] == '"';
    if (!in_quotes && c == '#') break;
    if (is_doubled) {
      masked[i] = masked[i + 1] = 'q';
      ++i;
    } else if (c == '"' && (in_quotes || at_start)) {
      in_quotes = !in_quotes;
    } else if (in_quotes) {
      masked[i] = 'q';
    }
    at_start = !in_quotes && (c == ' ' || (mark_of(c) & (kComma | kSemicolon | kTab)) != 0);
  }
  if (in_quotes) lines.fail("a quote is opened and not closed; write every row on one line, or leave the quotes out");
  return masked;
}

// The line before its comment and the white space there.
std::string_view without_comment(const TextLines& lines, std::string_view line) {
  const std::size_t start = line.find('#');
  std::string_view before = line.substr(0, start);
  while (!before.empty() && trimmed(before.substr(before.size() - 1)).empty()) before.remove_suffix(1);
  if (!before.empty()) return before;
  const std::string_view comment = line.substr(start);
  const std::string_view first_cell = trimmed(comment.substr(0, comment.find_first_of(",;\t ")));
  if (is_missing_value(first_cell)) lines.fail(not_a_number(first_cell));
  return {};
}

// Cells of `masked`, as the same places of `original`, quotes taken off.
void unmask(std::string_view masked, std::string_view original, std::vector<std::string_view>& cells) {
  for (std::string_view& cell : cells) {
    const auto place = static_cast<std::size_t>(cell.data() - masked.data());
    cell = original.substr(place, cell.size());
    if (cell.starts_with('"')) cell = without_quotes(cell);
  }
}

}  // namespace

bool LineSplitter::split(const TextLines& lines, std::vector<std::string_view>& cells) {
  if (lines.number() == 1 && declares_separator(lines)) return false;
  const std::string_view original = lines.whole_line();
  std::string_view line = original;
  unsigned char marks = marks_in(line);
  std::string masked;
  if ((marks & kQuote) != 0) {
    masked = with_quoted_parts_masked(lines);
    line = masked;
    marks = marks_in(line);
  }
  if ((marks & kComment) != 0) {
    line = without_comment(lines, line);
    marks = marks_in(line);
  }
  if (trimmed(line).empty()) return false;
  separator_ = choose_separator(lines, line, marks);
  require_separator_of_first_row(lines);
  if (!of_first_row_) of_first_row_ = separator_;
  split_columns(line, separator_, cells);
  if (!masked.empty()) unmask(masked, original, cells);
  return true;
}

bool LineSplitter::declares_separator(const TextLines& lines) {
  constexpr std::string_view kDeclaration = "sep=";
  const std::string_view line = lines.line();
  if (!lower_case(line.substr(0, kDeclaration.size())).starts_with(kDeclaration)) return false;
  const std::string_view separator = line.substr(kDeclaration.size());
  if (separator.size() > 1 || std::string_view(",;|:").find(separator) == std::string_view::npos) {
    lines.fail(shown(line) + " names no separator; use sep=, or sep=; or leave the line out");
  }
  declared_ = separator.empty() ? '\t' : separator.front();  // a tab goes with the white space at the end
  return true;
}

// Commas or semicolons before tabs, as tabs may pad them; but a tab within a cell is no padding.
char LineSplitter::choose_separator(const TextLines& lines, std::string_view line, unsigned char marks) const {
  if (declared_) return *declared_;
  if (of_first_row_ && (marks & mark_of(*of_first_row_)) != 0) return *of_first_row_;
  const bool has_tab = (marks & kTab) != 0;
  if ((marks & kComma) == 0 && (marks & kSemicolon) == 0) return has_tab ? '\t' : ' ';
  const bool has_both = (marks & kComma) != 0 && (marks & kSemicolon) != 0;
  if (has_both && !has_tab) lines.fail("both commas and semicolons; write x,y with decimal points");
  const char separator = (marks & kComma) != 0 ? ',' : ';';
  if (!has_tab) return separator;
  std::vector<std::string_view> cells;
  split_columns(line, separator, cells);
  for (const std::string_view cell : cells) {
    if (has_both || cell.find('\t') != std::string_view::npos) return '\t';
  }
  return separator;
}

// A comma in a row without others may be a decimal comma.
void LineSplitter::require_separator_of_first_row(const TextLines& lines) const {
  if (!of_first_row_ || separator_ == *of_first_row_ || (separator_ != ',' && separator_ != ';')) return;
  lines.fail(std::string(name_of(separator_)) + " between columns where the first row has " +
             std::string(name_of(*of_first_row_)) + "; separate all rows alike, and write decimal points");
}

}  // namespace mwt
