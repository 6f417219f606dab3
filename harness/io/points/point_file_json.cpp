#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.h"
#include "harness/io/points/point_formats.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

using Json = nlohmann::json;

// Picks the points out of the stream of the parser's events: a document tree of ten million points would take
// gigabytes. The depth counts open brackets: 1 within the document, 2 within "points", 3 within a point.
class PointCollector final : public Json::json_sax_t {
 public:
  PointCollector(const std::string& source, std::string_view text) : source_(source), text_(text) {}

  [[nodiscard]] bool found_points() const { return found_points_; }
  [[nodiscard]] std::vector<Point>& points() { return points_; }

  bool null() override { return other_value("null"); }
  bool boolean(bool) override { return other_value("a truth value"); }
  bool string(string_t& value) override { return other_value(shown(value)); }
  bool binary(binary_t&) override { return other_value("binary data"); }
  bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }

  bool key(string_t& name) override {
    if (depth_ == 1) points_are_next_ = name == "points";
    if (in_points_ && depth_ == 3) expected_ = name == "x" ? &x_ : name == "y" ? &y_ : nullptr;
    if (expected_ != nullptr && *expected_) fail_at_point("has " + name + " twice");
    return true;
  }

  bool start_object(std::size_t) override {
    if (expected_ != nullptr) fail_at_point("has an object for a coordinate");
    if (in_points_ && depth_ == 2) x_ = y_ = std::nullopt;
    ++depth_;
    return true;
  }

  bool end_object() override {
    --depth_;
    if (in_points_ && depth_ == 2) {
      if (!x_) fail_at_point("has no x");
      if (!y_) fail_at_point("has no y");
      points_.push_back({*x_, *y_});
    }
    return true;
  }

  bool start_array(std::size_t) override {
    if (expected_ != nullptr) fail_at_point("has an array for a coordinate");
    if (in_points_ && depth_ == 2) fail_at_point("is an array");
    if (depth_ == 1 && points_are_next_) {
      if (found_points_) throw InputError(source_ + ": a second list \"points\"; keep one");
      in_points_ = found_points_ = true;
    }
    ++depth_;
    return true;
  }

  bool end_array() override {
    --depth_;
    if (depth_ == 1) in_points_ = false;
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token, const Json::exception& error) override {
    const auto before = text_.substr(0, position == 0 ? 0 : position - 1);
    const std::string place = fmt::format("{}:{}", source_, 1 + std::count(before.begin(), before.end(), '\n'));
    constexpr int kNumberOverflow = 406;
    if (error.id == kNumberOverflow) {
      throw InputError(place + ": " + shown(last_token) + " is not a finite double; scale the data down");
    }
    throw InputError(place + ": no valid JSON at " + shown(last_token) +
                     "; expected {\"points\": [{\"x\": 1, \"y\": 2}, ...]}");
  }

 private:
  bool number(double value) {
    if (expected_ != nullptr) {
      *std::exchange(expected_, nullptr) = value;
    } else if (in_points_ && depth_ == 2) {
      fail_at_point("is a number");
    }
    return true;
  }

  bool other_value(const std::string& what) {
    if (expected_ != nullptr) fail_at_point("has " + what + " for a coordinate");
    if (in_points_ && depth_ == 2) fail_at_point("is " + what);
    return true;
  }

  [[noreturn]] void fail_at_point(const std::string& what) const {
    throw InputError(
        fmt::format("{}: points[{}] {}; a point is {{\"x\": 1, \"y\": 2}}", source_, points_.size(), what));
  }

  const std::string& source_;
  std::string_view text_;
  std::vector<Point> points_;
  int depth_ = 0;
  bool points_are_next_ = false;
  bool in_points_ = false;
  bool found_points_ = false;
  std::optional<double> x_;
  std::optional<double> y_;
  std::optional<double>* expected_ = nullptr;  // the coordinate whose value comes next
};

}  // namespace

std::vector<Point> parse_json_points(const std::string& source, std::string_view text) {
  PointCollector collector(source, text);
  Json::sax_parse(text.begin(), text.end(), &collector);
  if (!collector.found_points()) {
    throw InputError(source + ": no list \"points\"; expected {\"points\": [{\"x\": 1, \"y\": 2}, ...]}");
  }
  if (collector.points().empty()) throw InputError(source + ": the list \"points\" is empty");
  return std::move(collector.points());
}

}  // namespace mwt
