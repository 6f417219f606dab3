#include <charconv>
#include <cstdint>
#include <optional>

#include "geometry/point_formats.h"
#include "geometry/text_table.h"

namespace mwt {

namespace {

// Where a row's coordinates and, without a header that names them, its id stand.
struct PointColumns {
  std::size_t x = 0;
  std::size_t y = 1;
  std::optional<std::size_t> id;
};

// Precondition: the table stands at its first row.
PointColumns find_columns(const TextTable& table) {
  const std::optional<std::size_t> x = table.column_named("x");
  const std::optional<std::size_t> y = table.column_named("y");
  if (x && y) return {*x, *y, std::nullopt};
  switch (table.columns().size()) {
    case 2: return {};
    case 3: return {1, 2, 0};
    default:
      table.fail(std::to_string(table.columns().size()) +
                 " column(s); write x y, or id x y, or a header that names the columns x and y");
  }
}

std::int64_t id_in(const TextTable& table, std::size_t column) {
  const std::string_view text = table.columns()[column];
  const char* end = text.data() + text.size();
  std::int64_t id = 0;
  const auto [stop, error] = std::from_chars(text.data(), end, id);
  if (error == std::errc() && stop == end) return id;
  table.fail("3 columns, but " + shown(text) + " is no integer id; write x y, or a header that names x and y");
}

// Three columns of numbers could be anything; they are an id and a point only if the first column counts up.
void require_counting(const TextTable& table, std::size_t column, std::optional<std::int64_t>& previous) {
  const std::int64_t id = id_in(table, column);
  if (previous && id - 1 != *previous) {
    table.fail("3 columns, but the first does not count up (" + std::to_string(id) + " after " +
               std::to_string(*previous) + "), so it is no id; write x y, or a header that names x and y");
  }
  previous = id;
}

}  // namespace

std::vector<Point> parse_text_points(const std::string& source, std::string_view text) {
  TextTable table(source, text);
  std::vector<Point> points;
  PointColumns columns;
  std::optional<std::int64_t> previous_id;
  while (table.next_row()) {
    if (points.empty()) columns = find_columns(table);
    if (columns.id) require_counting(table, *columns.id, previous_id);
    points.push_back({table.number(columns.x), table.number(columns.y)});
  }
  if (points.empty()) table.fail_as_a_whole("no points in it; write one \"x y\" per line");
  return points;
}

}  // namespace mwt
