// The vertices of meshes: OFF (Geomview), PLY (Stanford), .node (Triangle). All in one plane z = constant.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/points/binary_number.h"
#include "harness/io/points/point_formats.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_file.h"
#include "harness/io/text/text_lines.h"
#include "harness/io/text/word_rows.h"

namespace mwt {

namespace {

// Heights must agree: points of space are none of the plane.
class Plane {
 public:
  explicit Plane(const std::string& source) : source_(source) {}

  void require(double z, std::size_t vertex) {
    if (vertex == 0) z_ = z;
    if (z == z_) return;
    throw InputError(fmt::format("{}: vertex {} has z = {}, others {}: no points of one plane; project them first",
                                 source_, vertex, number_text(z), number_text(z_)));
  }

 private:
  const std::string& source_;
  double z_ = 0;  // of vertex 0
};

std::vector<Point> require_points(std::vector<Point> points, const std::string& source) {
  if (points.empty()) throw InputError(source + ": no points in it");
  return points;
}

// What follows the vertices must be as many rows as the header states: otherwise it may state too few vertices.
void require_rest(WordRows& rows, std::size_t expected, const std::string& source) {
  std::size_t rest = 0;
  while (rows.next()) ++rest;
  if (rest == expected) return;
  throw InputError(
      fmt::format("{}: {} after the vertices, where its header states {}", source, counted(rest, "line"), expected));
}

// The types of PLY: their names, and how they are written.
struct PlyType {
  std::array<std::string_view, 2> names;
  NumberKind kind;
  std::size_t size;
};
constexpr std::array<PlyType, 8> kPlyTypes = {{{{"char", "int8"}, NumberKind::whole, 1},
                                               {{"uchar", "uint8"}, NumberKind::natural, 1},
                                               {{"short", "int16"}, NumberKind::whole, 2},
                                               {{"ushort", "uint16"}, NumberKind::natural, 2},
                                               {{"int", "int32"}, NumberKind::whole, 4},
                                               {{"uint", "uint32"}, NumberKind::natural, 4},
                                               {{"float", "float32"}, NumberKind::real, 4},
                                               {{"double", "float64"}, NumberKind::real, 8}}};

struct PlyProperty {
  std::string name;
  PlyType type;
};

// The header of a PLY file, as far as its vertices go.
class PlyHeader {
 public:
  PlyHeader(const std::string& source, std::string_view content) : source_(source) {
    constexpr std::string_view kEnd = "end_header";
    const std::size_t end = content.find(kEnd);
    const std::size_t line_end = end == std::string_view::npos ? end : content.find('\n', end);
    if (line_end == std::string_view::npos) fail("a PLY file without end_header");
    data_at_ = line_end + 1;
    TextLines lines(source, content.substr(0, end));
    while (lines.next()) {
      std::vector<std::string_view> words;
      split_columns(lines.line(), ' ', words);
      read(words);
    }
    if (!count_ || format_.empty()) fail("a PLY file without format or without 'element vertex'");
    for (std::size_t axis = 0; axis < 3; ++axis) axes_[axis] = place_of(std::string(1, "xyz"[axis]));
    if (!axes_[0] || !axes_[1]) fail("its vertices have no x and y");
  }

  [[nodiscard]] std::size_t count() const { return *count_; }
  [[nodiscard]] std::size_t data_at() const { return data_at_; }
  [[nodiscard]] bool is_text() const { return format_ == "ascii"; }
  [[nodiscard]] bool is_big_endian() const { return format_ == "binary_big_endian"; }
  [[nodiscard]] std::size_t other_elements() const { return other_elements_; }
  [[nodiscard]] const std::vector<PlyProperty>& properties() const { return properties_; }
  [[nodiscard]] std::optional<std::size_t> axis(std::size_t i) const { return axes_[i]; }

 private:
  void read(const std::vector<std::string_view>& words) {
    if (words.size() >= 2 && words[0] == "format") {
      format_ = words[1];
      if (!is_text() && !is_big_endian() && format_ != "binary_little_endian")
        fail("its format is unknown: " + shown(words[1]));
    } else if (words.size() == 3 && words[0] == "element") {
      begin_element(words[1], words[2]);
    } else if (words.size() == 3 && words[0] == "property" && is_vertex_) {
      properties_.push_back({std::string(words[2]), type_named(words[1])});
    } else if (words.size() > 3 && words[0] == "property" && is_vertex_) {
      fail("its vertices have a list as property, which is not read");
    } else if (words.empty() || std::ranges::find(kOthers, words[0]) == kOthers.end()) {
      fail("a line of its header begins with " + shown(words.empty() ? "" : words[0]));
    }
  }

  static constexpr std::array<std::string_view, 4> kOthers = {"ply", "comment", "obj_info", "property"};

  void begin_element(std::string_view name, std::string_view number) {
    const auto count = parse_whole_number<std::size_t>(number);
    if (!count || *count >= kNoIndex) fail("its number of elements is none: " + shown(number));
    is_vertex_ = name == "vertex";
    if (is_vertex_ && count_) fail("two elements 'vertex'");
    if (is_vertex_) count_ = count;
    if (!is_vertex_ && !count_) fail("its vertices do not come first; write them before other elements");
    if (!is_vertex_) other_elements_ += *count;
  }

  [[nodiscard]] PlyType type_named(std::string_view name) const {
    for (const PlyType& type : kPlyTypes) {
      if (std::ranges::find(type.names, name) != type.names.end()) return type;
    }
    fail("a property is of the unknown type " + shown(name));
  }

  [[nodiscard]] std::optional<std::size_t> place_of(const std::string& name) const {
    const auto found = std::ranges::find(properties_, name, &PlyProperty::name);
    if (found == properties_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - properties_.begin());
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(source_ + ": " + what); }

  const std::string& source_;
  std::string format_;
  std::optional<std::size_t> count_;
  bool is_vertex_ = false;  // the element that is read is the vertex
  std::vector<PlyProperty> properties_;
  std::array<std::optional<std::size_t>, 3> axes_;
  std::size_t other_elements_ = 0;
  std::size_t data_at_ = 0;
};

std::vector<Point> binary_vertices(const std::string& source, std::string_view data, const PlyHeader& header) {
  std::vector<std::size_t> place_of;  // of each property within a vertex
  std::size_t size = 0;
  for (const PlyProperty& property : header.properties()) {
    place_of.push_back(size);
    size += property.type.size;
  }
  if (data.size() / size < header.count()) throw InputError(source + ": a PLY file that ends before its last vertex");
  if (header.other_elements() == 0 && data.size() != size * header.count())
    throw InputError(source + ": a PLY file with more data than its header states");
  std::vector<Point> points;
  Plane plane(source);
  for (std::size_t v = 0; v < header.count(); ++v) {
    const auto coordinate = [&](std::size_t axis) {
      const std::size_t property = *header.axis(axis);
      const PlyType& type = header.properties()[property].type;
      const NumberFormat format{type.kind, type.size, header.is_big_endian()};
      const double value = value_of(bits_of(data.substr(v * size + place_of[property]), format), format);
      if (!std::isfinite(value))
        throw InputError(fmt::format("{}: vertex {} has a coordinate that is not finite", source, v));
      return value;
    };
    points.push_back({coordinate(0), coordinate(1)});
    if (header.axis(2)) plane.require(coordinate(2), v);
  }
  return points;
}

}  // namespace

std::vector<Point> parse_off_points(const std::string& source, std::string_view text) {
  WordRows rows(source, text);
  rows.require_next("its counts");
  const std::string word = lower_case(rows.words().front());
  if (!word.ends_with("off")) rows.fail("does not begin with OFF");
  if (word.ends_with("noff") || word.ends_with("4off"))
    rows.fail(shown(word) + ": vertices of other dimensions are not read");
  const bool are_counts_behind = rows.words().size() > 1;
  if (!are_counts_behind) rows.require_next("its counts");
  const std::size_t count = rows.count(are_counts_behind ? 1 : 0), faces = rows.count(are_counts_behind ? 2 : 1);
  std::vector<Point> points;
  Plane plane(source);
  while (points.size() < count) {
    rows.require_next(fmt::format("vertex {} of {}", points.size(), count));
    plane.require(rows.number(2), points.size());
    points.push_back({rows.number(0), rows.number(1)});
  }
  require_rest(rows, faces, source);
  return require_points(std::move(points), source);
}

std::vector<Point> parse_ply_points(const std::string& source, std::string_view content) {
  const PlyHeader header(source, content);
  const std::string_view data = content.substr(header.data_at());
  if (!header.is_text()) return require_points(binary_vertices(source, data, header), source);
  const std::string text = as_plain_text(std::string(data), source);
  WordRows rows(source, text);
  std::vector<Point> points;
  Plane plane(source);
  while (points.size() < header.count()) {
    if (!rows.next())
      throw InputError(fmt::format("{}: ends before vertex {} of {}", source, points.size(), header.count()));
    if (rows.words().size() != header.properties().size())
      throw InputError(fmt::format("{}: vertex {} has {}, the header names {}", source, points.size(),
                                   counted(rows.words().size(), "number"), header.properties().size()));
    if (header.axis(2)) plane.require(rows.number(*header.axis(2)), points.size());
    points.push_back({rows.number(*header.axis(0)), rows.number(*header.axis(1))});
  }
  require_rest(rows, header.other_elements(), source);
  return require_points(std::move(points), source);
}

std::vector<Point> parse_node_points(const std::string& source, std::string_view text) {
  WordRows rows(source, text);
  rows.require_next("its counts");
  const std::size_t count = rows.count(0);
  if (rows.words().size() < 2 || rows.words()[1] != "2")
    rows.fail("its dimension is not 2; a .node file begins with 'POINTS 2 ATTRIBUTES MARKERS'");
  std::vector<Point> points;
  while (points.size() < count) {
    rows.require_next(fmt::format("vertex {} of {}", points.size(), count));
    points.push_back({rows.number(1), rows.number(2)});
  }
  if (rows.next()) rows.fail(fmt::format("more than the {} vertices of the first line", count));
  return require_points(std::move(points), source);
}

}  // namespace mwt
