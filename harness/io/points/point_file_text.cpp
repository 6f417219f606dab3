#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/points/point_formats.h"
#include "harness/io/text/cell_text.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_lines.h"
#include "harness/io/text/text_table.h"

namespace mwt {

namespace {

// Where a row's coordinates and, without a header that names them, its id stand.
struct PointColumns {
  std::size_t x = 0;
  std::size_t y = 1;
  std::optional<std::size_t> id;
};

bool is_part_of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (static_cast<unsigned char>(c) & 0x80) != 0;
}

// Whether a name (in lower case) has `axis` as a word: "x", "x [m]", "point_x".
bool has_word(std::string_view name, char axis) {
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool begins = i == 0 || !is_part_of_word(name[i - 1]);
    const bool ends = i + 1 == name.size() || !is_part_of_word(name[i + 1]);
    if (name[i] == axis && begins && ends) return true;
  }
  return false;
}

// The column that is called `axis`, or else the only one that has it, and not the other axis, as a word.
std::optional<std::size_t> column_of_axis(const TextTable& table, char axis, char other_axis) {
  if (const auto exact = table.column_named(std::string_view(&axis, 1))) return exact;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < table.header().size(); ++i) {
    const std::string& name = table.header()[i];
    if (!has_word(name, axis) || has_word(name, other_axis)) continue;
    if (found) {
      table.fail_in_header(fmt::format("columns {} and {} could both be {}; call the coordinates x and y",
                                       shown(table.header()[*found]), shown(name), axis));
    }
    found = i;
  }
  return found;
}

// Precondition: a header that names neither x nor y.
PointColumns columns_by_place(const TextTable& table) {
  const auto& header = table.header();
  const auto labels = std::count_if(header.begin(), header.end(), names_row_labels);
  if (header.size() == 2 && labels == 0) return {};
  if (header.size() == 3 && labels == 1 && names_row_labels(header[0])) return {1, 2, 0};
  table.fail_in_header("the header does not name the columns of the coordinates; call them x and y");
}

PointColumns columns_by_header(const TextTable& table) {
  const std::optional<std::size_t> x = column_of_axis(table, 'x', 'y');
  const std::optional<std::size_t> y = column_of_axis(table, 'y', 'x');
  if (x && y) return {*x, *y, std::nullopt};
  if (x || y) {
    table.fail_in_header(fmt::format("the header names {} but not {}; call both coordinates by their names",
                                     x ? "x" : "y", x ? "y" : "x"));
  }
  return columns_by_place(table);
}

// Precondition: the table stands at its first row.
PointColumns find_columns(const TextTable& table) {
  if (!table.header().empty()) return columns_by_header(table);
  switch (table.columns().size()) {
    case 2: return {};
    case 3: return {1, 2, 0};
    default:
      table.fail(fmt::format("{} column(s); write x y, or id x y, or a header that names the columns x and y",
                             table.columns().size()));
  }
}

std::int64_t id_in(const TextTable& table, std::size_t column) {
  const std::string_view text = table.columns()[column];
  if (const auto id = parse_whole_number<std::int64_t>(text)) return *id;
  table.fail("3 columns, but " + shown(text) + " is no integer id; write x y, or a header that names x and y");
}

// Three columns of numbers could be anything; they are an id and a point only if the first column counts up.
void require_counting(const TextTable& table, std::size_t column, std::optional<std::int64_t>& previous) {
  const std::int64_t id = id_in(table, column);
  if (previous && (id <= *previous || id - 1 != *previous)) {
    table.fail(
        fmt::format("3 columns, but the first does not count up ({} after {}), so it is no id; write x y, or a header "
                    "that names x and y",
                    id, *previous));
  }
  previous = id;
}

// A place from 1, or a name.
std::size_t column_called(const TextTable& table, const std::string& name) {
  const std::size_t width = table.columns().size();
  if (const auto place = parse_whole_number<std::size_t>(name)) {
    if (*place >= 1 && *place <= width) return *place - 1;
    table.fail(fmt::format("no column {}; there are {}", *place, width));
  }
  if (const auto column = table.column_named(lower_case(name))) return *column;
  if (table.header().empty())
    table.fail("no header, so no column is called " + shown(name) + "; give the columns' places, such as 1,2");
  table.fail_in_header("no column is called " + shown(name) + "; there are " + joined(table.header(), ", "));
}

PointColumns columns_called(const TextTable& table, const ColumnNames& names) {
  const PointColumns columns{column_called(table, names.x), column_called(table, names.y), std::nullopt};
  if (columns.x == columns.y) table.fail("x and y are the same column; name two");
  return columns;
}

}  // namespace

ColumnNames parse_column_names(const std::string& text) {
  const std::vector<std::string> names = split(text, ',');
  if (names.size() == 2 && !trimmed(names[0]).empty() && !trimmed(names[1]).empty())
    return {std::string(trimmed(names[0])), std::string(trimmed(names[1]))};
  throw InputError(shown(text) + " does not name two columns; write x,y or their places, such as 2,3");
}

std::vector<Point> parse_text_points(const std::string& source, std::string_view text,
                                     const std::optional<ColumnNames>& names) {
  TextTable table(source, text);
  std::vector<Point> points;
  PointColumns columns;
  std::optional<std::int64_t> previous_id;
  while (table.next_row()) {
    if (points.empty()) columns = names ? columns_called(table, *names) : find_columns(table);
    if (columns.id) require_counting(table, *columns.id, previous_id);
    points.push_back({table.number(columns.x), table.number(columns.y)});
  }
  if (points.empty()) table.fail_as_a_whole("no points in it; write one \"x y\" per line");
  return points;
}

}  // namespace mwt
