#include "harness/io/text/cell_text.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/number_text.h"
#include "base/unicode.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

bool contains_any(std::string_view text, std::string_view characters) {
  return text.find_first_of(characters) != std::string_view::npos;
}

bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Minus signs and dashes of typesetting programs.
bool is_typographic_minus(char32_t code_point) {
  return (code_point >= 0x2010 && code_point <= 0x2015) || code_point == 0x2212 || code_point == 0xFE63 ||
         code_point == 0xFF0D;
}

// The remedy for a character that is no ASCII, or nothing if there is none.
std::optional<std::string> remedy_for_foreign_characters(std::string_view cell) {
  while (!cell.empty()) {
    const std::optional<Character> character = first_character(cell);
    if (!character) return "it has bytes that are no UTF-8; save the file as UTF-8";
    if (character->code_point >= 0x80) {
      const std::string name = code_point_name(character->code_point);
      return is_typographic_minus(character->code_point) ? "its minus sign is " + name + "; write -"
                                                         : "it has the character " + name + "; write it without";
    }
    cell.remove_prefix(character->size);
  }
  return std::nullopt;
}

bool is_number_after(std::string_view cell, std::string_view replaced, char replacement) {
  std::string text(cell);
  for (char& c : text) {
    if (replaced.find(c) != std::string_view::npos) c = replacement;
  }
  return parse_number(text).has_value();
}

// Whether a number stands in front of something else, as in "59.3 deg" or "0.5f".
bool is_number_with_unit(std::string_view cell) {
  const std::size_t end = cell.find_last_of("0123456789.");
  if (end == std::string_view::npos) return false;
  const std::string_view rest = trimmed(cell.substr(end + 1));
  return !rest.empty() && is_ascii_letter(rest[0]) && parse_number(trimmed(cell.substr(0, end + 1))).has_value();
}

std::string remedy_for(std::string_view cell) {
  if (is_missing_value(cell)) return "the value is missing; leave the row out";
  if (const auto remedy = remedy_for_foreign_characters(cell)) return *remedy;
  if (contains_any(cell, "()[]{}<>")) return "write numbers without brackets";
  if (contains_any(cell, "\"'")) return "write numbers without quotes";
  if (cell.starts_with("%") || cell.starts_with("//") || cell.starts_with("!")) return "comments begin with #";
  if (is_number_after(cell, ",", '.')) return "write a decimal point instead of the comma";
  if (is_number_after(cell, "dD", 'e')) return "write the exponent with e, as in 1e-3";
  if (lower_case(cell).find("0x") != std::string::npos) return "write it as a decimal number";
  if (is_number_with_unit(cell)) return "write the number alone, without what follows it";
  return "write one such as 1.5 or 2e-3";
}

constexpr std::array<std::string_view, 21> kMissing = {
    "na",    "n/a",     "n.a.",   "n.a",  "nan",   "null",    "nil",   "none",   "missing", "unknown", "void",
    "empty", "no data", "nodata", "#n/a", "#ref!", "#value!", "#num!", "#name?", "#null!",  "#div/0!"};

constexpr std::array<std::string_view, 13> kRowLabels = {"",      "id",     "index", "idx",   "no",  "nr", "name",
                                                         "label", "number", "node",  "point", "key", "fid"};

}  // namespace

std::string not_a_number(std::string_view cell) { return shown(cell) + " is not a number; " + remedy_for(cell); }

bool is_missing_value(std::string_view cell) {
  return std::find(kMissing.begin(), kMissing.end(), lower_case(cell)) != kMissing.end();
}

bool is_column_name(std::string_view cell) {
  const std::optional<Character> first = first_character(cell);
  const bool begins_like_one = first && (is_letter(first->code_point) || first->code_point == '_');
  return begins_like_one && !is_missing_value(cell) && !parse_number(cell);
}

bool names_row_labels(std::string_view column) {
  return std::find(kRowLabels.begin(), kRowLabels.end(), column) != kRowLabels.end();
}

std::string_view without_quotes(std::string_view cell) {
  if (cell.size() >= 2 && cell.front() == cell.back() && (cell.front() == '"' || cell.front() == '\'')) {
    return trimmed(cell.substr(1, cell.size() - 2));
  }
  return cell;
}

}  // namespace mwt
