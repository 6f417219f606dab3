#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/error.h"
#include "harness/io/points/point_formats.h"
#include "harness/io/text/json_text.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

using Json = nlohmann::json;

constexpr const char* kForms =
    "expected {\"points\": [{\"x\": 1, \"y\": 2}, ...]}, {\"points\": [[1, 2], ...]}, [[1, 2], ...], {\"points_x\": "
    "[1, ...], "
    "\"points_y\": [2, ...]} or GeoJSON points";

[[noreturn]] void fail_to_parse(const std::string& source, std::string_view text, std::size_t position,
                                const std::string& last_token, const Json::exception& error) {
  const auto before = text.substr(0, position == 0 ? 0 : position - 1);
  const std::string place = fmt::format("{}:{}", source, 1 + std::count(before.begin(), before.end(), '\n'));
  constexpr int kNumberOverflow = 406;
  if (error.id == kNumberOverflow)
    throw InputError(place + ": " + shown(last_token) + " is not a finite double; scale the data down");
  throw InputError(place + ": no valid JSON at " + shown(last_token) + "; " + kForms);
}

// A coordinate, "y" or the second of a list, as it comes.
class Coordinates {
 public:
  void begin() {
    values_ = {};
    count_ = 0;
  }

  // In an object: by name. Returns whether the coordinate was there already.
  bool is_given(std::size_t axis) const { return values_[axis].has_value(); }
  void set(std::size_t axis, double value) { values_[axis] = value; }

  // In a list: the next one.
  void add(double value) {
    if (count_ < values_.size()) values_[count_] = value;
    ++count_;
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] bool is_complete() const { return values_[0] && values_[1]; }
  [[nodiscard]] Point point() const { return {*values_[0], *values_[1]}; }

 private:
  std::array<std::optional<double>, 2> values_;
  std::size_t count_ = 0;
};

// Picks the points out of the stream of the parser's events: a document tree of ten million points would take
// gigabytes. They are in a list, that of the document or its "points", of objects or lists; or in two lists of numbers,
// "points_x" and "points_y" (CG:SHOP 2025) or "x" and "y" (CG:SHOP 2022).
class PointCollector final : public Json::json_sax_t {
 public:
  PointCollector(const std::string& source, std::string_view text) : source_(source), text_(text) {}

  [[nodiscard]] std::vector<Point> take() {
    const auto& [x, y] = columns_;
    if (found_points_ && (found_column_[0] || found_column_[1]))
      throw InputError(source_ + ": both a list of points and lists of coordinates; keep one");
    if (found_points_) {
      if (points_.empty()) throw InputError(source_ + ": the list of points is empty");
      return std::move(points_);
    }
    if (found_column_[0] != found_column_[1]) {
      throw InputError(fmt::format("{}: a list of {} coordinates, but none of {}", source_,
                                   found_column_[0] ? "x" : "y", found_column_[0] ? "y" : "x"));
    }
    if (!found_column_[0]) throw InputError(source_ + ": no list of points; " + kForms);
    if (x.size() != y.size())
      throw InputError(fmt::format("{}: {} x coordinates, but {} y coordinates", source_, x.size(), y.size()));
    if (x.empty()) throw InputError(source_ + ": the lists of coordinates are empty");
    for (std::size_t i = 0; i < x.size(); ++i) points_.push_back({x[i], y[i]});
    return std::move(points_);
  }

  bool null() override { return other_value("null"); }
  bool boolean(bool) override { return other_value("a truth value"); }
  bool string(string_t& value) override { return other_value(shown(value)); }
  bool binary(binary_t&) override { return other_value("binary data"); }
  bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }

  bool key(string_t& name) override {
    if (depth_ == 1) key_ = name;
    if (!is_in_point() || point_is_list_ || depth_ != list_depth_ + 1) return true;
    axis_ = name == "x" ? std::optional(0) : name == "y" ? std::optional(1) : std::nullopt;
    if (axis_ && point_.is_given(*axis_)) fail_at_point("has " + name + " twice");
    return true;
  }

  bool start_object(std::size_t) override {
    begin_value("an object");
    if (depth_ == list_depth_) begin_point(false);
    ++depth_;
    return true;
  }

  bool end_object() override {
    --depth_;
    if (depth_ != list_depth_) return true;
    if (!point_.is_given(0)) fail_at_point("has no x");
    if (!point_.is_given(1)) fail_at_point("has no y");
    points_.push_back(point_.point());
    return true;
  }

  bool start_array(std::size_t) override {
    begin_value("an array");
    if (depth_ == list_depth_) {
      begin_point(true);
    } else if (depth_ == 0 || (depth_ == 1 && is_in_object_ && key_ == "points")) {
      if (found_points_) throw InputError(source_ + ": a second list \"points\"; keep one");
      found_points_ = true;
      list_depth_ = depth_ + 1;
    } else if (depth_ == 1 && is_in_object_) {
      begin_column();
    }
    ++depth_;
    return true;
  }

  bool end_array() override {
    --depth_;
    if (depth_ == list_depth_) {
      if (point_.count() != 2) fail_at_point(fmt::format("has {} coordinates", point_.count()));
      points_.push_back(point_.point());
    } else if (depth_ + 1 == list_depth_) {
      list_depth_ = kNone;
    } else if (depth_ == 1) {
      column_.reset();
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token, const Json::exception& error) override {
    fail_to_parse(source_, text_, position, last_token, error);
  }

 private:
  static constexpr int kNone = std::numeric_limits<int>::min();  // a depth at which nothing is

  // Within a value of the list of points.
  [[nodiscard]] bool is_in_point() const { return list_depth_ != kNone && depth_ > list_depth_; }

  // An object or a list begins.
  void begin_value(const char* what) {
    if (depth_ == 0) is_in_object_ = what == std::string_view("an object");
    if (axis_ || (is_in_point() && point_is_list_)) fail_at_point(fmt::format("has {} for a coordinate", what));
    if (column_ && depth_ == 2) fail_in_column(what);
  }

  void begin_point(bool is_list) {
    point_.begin();
    point_is_list_ = is_list;
  }

  void begin_column() {
    for (const std::size_t axis : {0U, 1U}) {
      const char* const name = axis == 0 ? "x" : "y";
      if (key_ != name && key_ != std::string("points_") + name) continue;
      if (found_column_[axis])
        throw InputError(fmt::format("{}: a second list of {} coordinates; keep one", source_, name));
      found_column_[axis] = true;
      column_ = axis;
    }
  }

  bool number(double value) {
    if (axis_) {
      point_.set(*std::exchange(axis_, std::nullopt), value);
    } else if (is_in_point()) {
      if (point_is_list_) point_.add(value);
    } else if (depth_ == list_depth_) {
      fail_at_point("is a number");
    } else if (column_ && depth_ == 2) {
      columns_[*column_].push_back(value);
    }
    return true;
  }

  bool other_value(const std::string& what) {
    if (axis_ || (is_in_point() && point_is_list_)) fail_at_point("has " + what + " for a coordinate");
    if (depth_ == list_depth_) fail_at_point("is " + what);
    if (column_ && depth_ == 2) fail_in_column(what);
    return true;
  }

  [[noreturn]] void fail_in_column(const std::string& what) const {
    throw InputError(
        fmt::format("{}: {}[{}] is {}; a coordinate is a number", source_, key_, columns_[*column_].size(), what));
  }

  [[noreturn]] void fail_at_point(const std::string& what) const {
    throw InputError(
        fmt::format("{}: points[{}] {}; a point is {{\"x\": 1, \"y\": 2}} or [1, 2]", source_, points_.size(), what));
  }

  const std::string& source_;
  std::string_view text_;
  std::vector<Point> points_;
  std::array<std::vector<double>, 2> columns_;
  std::array<bool, 2> found_column_{};
  std::optional<std::size_t> column_;  // the list of coordinates that is read
  int depth_ = 0;                      // open brackets
  bool is_in_object_ = false;          // the document is an object
  std::string key_;                    // the last one of the document's own
  int list_depth_ = kNone;             // open brackets within the list of points
  bool found_points_ = false;
  bool point_is_list_ = false;
  Coordinates point_;
  std::optional<std::size_t> axis_;  // the coordinate whose value comes next, in an object
};

// GeoJSON (RFC 7946): all its points.
class GeoJson {
 public:
  explicit GeoJson(const std::string& source) : source_(source) {}

  std::vector<Point> points_of(const Json& document) {
    add(document, 0);
    if (points_.empty()) throw InputError(source_ + ": GeoJSON without points");
    return std::move(points_);
  }

 private:
  // Collections within collections: more than a few are an attack on the stack.
  static constexpr int kMaxDepth = 100;

  void add(const Json& object, int depth) {
    if (depth > kMaxDepth) fail(fmt::format("GeoJSON collections are nested more than {} deep", kMaxDepth));
    const std::string type = object.is_object() ? object.value("type", "") : "";
    if (type == "FeatureCollection") {
      for (const Json& feature : list_in(object, "features")) add(feature, depth + 1);
    } else if (type == "GeometryCollection") {
      for (const Json& geometry : list_in(object, "geometries")) add(geometry, depth + 1);
    } else if (type == "Feature") {
      const auto geometry = object.find("geometry");
      if (geometry == object.end() || geometry->is_null()) fail("a feature without geometry");
      add(*geometry, depth + 1);
    } else if (type == "MultiPoint") {
      for (const Json& position : list_in(object, "coordinates")) add_position(position);
    } else if (type == "Point") {
      add_position(list_in(object, "coordinates"));
    } else {
      fail("GeoJSON of type " + shown(type) + " is no point; give Point and MultiPoint only");
    }
  }

  [[nodiscard]] const Json& list_in(const Json& object, const char* key) const {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_array()) fail(fmt::format("GeoJSON without the list \"{}\"", key));
    return *found;
  }

  // "[1,2,3]", as far as it is flat.
  [[nodiscard]] static std::string shown_position(const Json& position) {
    if (!position.is_array()) return shown_json(position);
    std::string text;
    for (const Json& number : position) {
      constexpr std::size_t kMaxShown = 60;
      if (text.size() > kMaxShown) break;
      text += (text.empty() ? "" : ",") + (number.is_structured() ? shown_json(number) : number.dump());
    }
    return shown('[' + text + ']');
  }

  void add_position(const Json& position) {
    const bool is_pair =
        position.is_array() && position.size() == 2 && position[0].is_number() && position[1].is_number();
    if (!is_pair)
      fail(fmt::format("point {} of this GeoJSON is not two numbers: {}", points_.size(), shown_position(position)));
    points_.push_back({position[0].get<double>(), position[1].get<double>()});
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(source_ + ": " + what); }

  const std::string& source_;
  std::vector<Point> points_;
};

// Its "type" comes first, or "coordinates" somewhere.
bool looks_like_geojson(std::string_view text) {
  return text.find("\"coordinates\"") != std::string_view::npos && text.find("\"points\"") == std::string_view::npos;
}

}  // namespace

std::vector<Point> parse_json_points(const std::string& source, std::string_view text) {
  PointCollector collector(source, text);
  if (!looks_like_geojson(text)) {
    Json::sax_parse(text.begin(), text.end(), &collector);
    return collector.take();
  }
  try {
    return GeoJson(source).points_of(Json::parse(text.begin(), text.end()));
  } catch (const Json::parse_error& error) {
    fail_to_parse(source, text, error.byte, "this place", error);
  } catch (const Json::exception& error) {
    throw InputError(source + ": no valid GeoJSON: " + error.what());
  }
}

}  // namespace mwt
