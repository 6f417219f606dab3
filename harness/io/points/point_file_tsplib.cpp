#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/number_text.h"
#include "harness/io/points/point_formats.h"
#include "harness/io/text/cell_text.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

constexpr std::string_view kNodes = "node_coord_section";
constexpr std::string_view kDisplay = "display_data_section";

constexpr std::array<std::string_view, 8> kSections = {kNodes,
                                                       kDisplay,
                                                       "depot_section",
                                                       "demand_section",
                                                       "edge_data_section",
                                                       "fixed_edges_section",
                                                       "edge_weight_section",
                                                       "tour_section"};

// Other keywords; some files have them without a colon.
constexpr std::array<std::string_view, 11> kKeywords = {"eof",
                                                        "name",
                                                        "type",
                                                        "comment",
                                                        "dimension",
                                                        "edge_weight_type",
                                                        "capacity",
                                                        "edge_data_format",
                                                        "node_coord_type",
                                                        "display_data_type",
                                                        "edge_weight_format"};

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

template <class Words>
bool contains(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_keyword(std::string_view line) {
  const std::string key = parse_entry(line).key;
  return line.find(':') != std::string_view::npos || contains(kSections, key) || contains(kKeywords, key);
}

double parse_coordinate(const TextLines& lines, std::string_view text) {
  const std::optional<double> value = parse_number(text);
  if (!value) lines.fail(not_a_number(text));
  if (!std::isfinite(*value)) lines.fail(shown(text) + " is not a finite double; scale the data down");
  return *value;
}

bool begins_like_a_number(std::string_view line) {
  return (line[0] >= '0' && line[0] <= '9') || line[0] == '-' || line[0] == '+' || line[0] == '.';
}

// Whether the line is the next keyword ("EOF", another section) rather than a node with a name in front. Some files
// close a section with -1.
bool ends_section(std::string_view line, const std::vector<std::string_view>& columns) {
  if (begins_like_a_number(line)) return line == "-1";
  const bool is_named_node = columns.size() == 3 && parse_number(columns[1]) && parse_number(columns[2]);
  return !is_named_node && is_keyword(line);
}

// A node's number, or its name.
bool is_label(std::string_view text) {
  return parse_whole_number<std::int64_t>(text).has_value() || is_column_name(without_quotes(text));
}

// Reads "node x y" per line. Returns whether it stopped at another keyword, which is then the current line.
bool read_coordinates(TextLines& lines, std::vector<Point>& points) {
  std::vector<std::string_view> columns;
  while (lines.next()) {
    const std::string_view line = lines.line();
    if (line.empty()) continue;
    split_columns(line, ' ', columns);
    if (ends_section(line, columns)) return true;
    if (columns.size() != 3) {
      lines.fail(fmt::format("{} column(s); a node is a number, x and y (points in the plane only)", columns.size()));
    }
    if (!is_label(columns[0])) lines.fail(shown(columns[0]) + " is not a node's number");
    points.push_back({parse_coordinate(lines, columns[1]), parse_coordinate(lines, columns[2])});
  }
  return false;
}

// The content of a file, section by section.
class TsplibReader {
 public:
  TsplibReader(const std::string& source, std::string_view text) : lines_(source, text) {}

  std::vector<Point> read() {
    bool has_line = lines_.next();
    while (has_line) {
      const Entry entry = parse_entry(lines_.line());
      if (entry.key == "eof") break;
      if (entry.key == "dimension") read_dimension(entry.value);
      if (entry.key == "edge_weight_type") weight_type_ = entry.value;
      if (entry.key == kNodes) {
        has_line = read_section(nodes_, "NODE_COORD_SECTION");
      } else if (entry.key == kDisplay && !nodes_) {
        has_line = read_section(display_, "DISPLAY_DATA_SECTION");
      } else {
        has_line = lines_.next();
      }
    }
    if (nodes_) return checked(*nodes_, "NODE_COORD_SECTION");
    if (display_) return checked(*display_, "DISPLAY_DATA_SECTION");
    lines_.fail_as_a_whole("no NODE_COORD_SECTION" +
                           (weight_type_.empty() ? "" : " (EDGE_WEIGHT_TYPE " + shown(weight_type_) + ")") +
                           "; only instances with coordinates in the plane can be read");
  }

 private:
  void read_dimension(std::string_view text) {
    const auto dimension = parse_whole_number<std::uint64_t>(text);
    if (!dimension) lines_.fail("DIMENSION " + shown(text) + " is not a number of points");
    if (dimension_ && *dimension_ != *dimension) lines_.fail("a second DIMENSION; keep the right one");
    dimension_ = dimension;
  }

  bool read_section(std::optional<std::vector<Point>>& points, const std::string& name) {
    if (points) lines_.fail("a second " + name + "; keep one");
    return read_coordinates(lines_, points.emplace());
  }

  std::vector<Point> checked(std::vector<Point>& points, const std::string& section) const {
    if (dimension_ && *dimension_ != points.size()) {
      lines_.fail_as_a_whole(fmt::format("DIMENSION is {}, but {} has {} points; correct one of them", *dimension_,
                                         section, points.size()));
    }
    if (points.empty()) lines_.fail_as_a_whole("no points in " + section);
    return std::move(points);
  }

  TextLines lines_;
  std::optional<std::vector<Point>> nodes_;
  std::optional<std::vector<Point>> display_;
  std::optional<std::uint64_t> dimension_;
  std::string weight_type_;
};

}  // namespace

std::vector<Point> parse_tsplib_points(const std::string& source, std::string_view text) {
  return TsplibReader(source, text).read();
}

bool looks_like_tsplib(std::string_view text) {
  TextLines lines("", text);
  while (lines.next()) {
    const std::string_view line = lines.line();
    if (!line.empty() && begins_like_a_number(line)) return false;
    if (contains(kSections, parse_entry(line).key)) return true;
  }
  return false;
}

}  // namespace mwt
