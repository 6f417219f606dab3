#include <charconv>
#include <cmath>
#include <optional>

#include "geometry/number_text.h"
#include "geometry/point_formats.h"
#include "geometry/text_lines.h"

namespace mwt {

namespace {

constexpr std::string_view kCoordinateSection = "node_coord_section";

// "KEY : value", "KEY: value" or "KEY".
struct Entry {
  std::string key;
  std::string_view value;
};

Entry parse_entry(std::string_view line) {
  const std::size_t end = std::min(line.find_first_of(": \t"), line.size());
  std::string_view value = trimmed(line.substr(end));
  if (value.starts_with(':')) value = trimmed(value.substr(1));
  return {lower_case(line.substr(0, end)), value};
}

std::size_t parse_dimension(const TextLines& lines, std::string_view text) {
  std::size_t dimension = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, dimension);
  if (error != std::errc() || stop != end) lines.fail("DIMENSION " + shown(text) + " is not a number of points");
  return dimension;
}

double parse_coordinate(const TextLines& lines, std::string_view text) {
  const std::optional<double> value = parse_number(text);
  if (!value) lines.fail(shown(text) + " is not a number; write one such as 1.5 or 2e-3");
  if (!std::isfinite(*value)) lines.fail(shown(text) + " is not a finite double; scale the data down");
  return *value;
}

bool is_integer(std::string_view text) {
  long long value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && stop == text.data() + text.size();
}

// Numbers start with a digit, a sign or a point; the next keyword ("EOF", another section) with a letter. Some files
// close a section with -1.
bool ends_section(std::string_view line) {
  const char c = line.front();
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || line == "-1";
}

// Reads "number x y" per line. Returns whether it stopped at another keyword, which is then the current line.
bool read_coordinates(TextLines& lines, std::vector<Point>& points) {
  std::vector<std::string_view> columns;
  while (lines.next()) {
    if (lines.line().empty()) continue;
    if (ends_section(lines.line())) return true;
    split_columns(lines.line(), ' ', columns);
    if (columns.size() != 3) {
      lines.fail(std::to_string(columns.size()) + " column(s); a node is a number, x and y (points in the plane only)");
    }
    if (!is_integer(columns[0])) lines.fail(shown(columns[0]) + " is not a node's number");
    points.push_back({parse_coordinate(lines, columns[1]), parse_coordinate(lines, columns[2])});
  }
  return false;
}

}  // namespace

std::vector<Point> parse_tsplib_points(const std::string& source, std::string_view text) {
  TextLines lines(source, text);
  std::vector<Point> points;
  std::optional<std::size_t> dimension;
  std::string weight_type;
  bool has_section = false;
  bool has_line = lines.next();
  while (has_line) {
    const Entry entry = parse_entry(lines.line());
    if (entry.key == "dimension") dimension = parse_dimension(lines, entry.value);
    if (entry.key == "edge_weight_type") weight_type = entry.value;
    if (entry.key == "eof") break;
    if (entry.key == kCoordinateSection) {
      if (has_section) lines.fail("a second NODE_COORD_SECTION; keep one");
      has_section = true;
      has_line = read_coordinates(lines, points);
    } else {
      has_line = lines.next();
    }
  }
  if (!has_section) {
    lines.fail_as_a_whole("no NODE_COORD_SECTION" +
                          (weight_type.empty() ? "" : " (EDGE_WEIGHT_TYPE " + shown(weight_type) + ")") +
                          "; only instances with coordinates in the plane can be read");
  }
  if (dimension && *dimension != points.size()) {
    lines.fail_as_a_whole("DIMENSION is " + std::to_string(*dimension) + ", but NODE_COORD_SECTION has " +
                          std::to_string(points.size()) + " points; correct one of them");
  }
  if (points.empty()) lines.fail_as_a_whole("no points in NODE_COORD_SECTION");
  return points;
}

}  // namespace mwt
