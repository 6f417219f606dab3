// Well-known text (OGC Simple Feature Access): POINT and MULTIPOINT.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/points/point_formats.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Words, numbers, brackets and commas, one after the other.
class Tokens {
 public:
  Tokens(const std::string& source, std::string_view text) : source_(source), text_(text) { next(); }

  [[nodiscard]] std::string_view now() const { return now_; }
  [[nodiscard]] bool is_at_end() const { return now_.empty(); }
  [[nodiscard]] bool is_word() const { return !now_.empty() && is_letter(now_.front()); }

  void next() {
    place_ = std::min(text_.find_first_not_of(" \t\r\n", place_ + now_.size()), text_.size());
    std::size_t end = place_;
    while (end < text_.size() && std::string_view(" \t\r\n(),;").find(text_[end]) == std::string_view::npos) ++end;
    if (end == place_ && end < text_.size()) ++end;
    now_ = text_.substr(place_, end - place_);
  }

  bool take(std::string_view token) {
    if (now_ != token) return false;
    next();
    return true;
  }

  void require(std::string_view token) {
    if (!take(token)) fail(fmt::format("'{}' where there should be '{}'", shown_now(), token));
  }

  double take_number() {
    const std::optional<double> value = parse_number(now_);
    if (!value) fail(fmt::format("'{}' is not a number", shown_now()));
    if (!std::isfinite(*value)) fail(fmt::format("'{}' is not a finite double; scale the data down", shown_now()));
    next();
    return *value;
  }

  [[noreturn]] void fail(const std::string& what) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(place_), '\n');
    throw InputError(fmt::format("{}:{}: {}", source_, line, what));
  }

  [[nodiscard]] std::string shown_now() const {
    const std::string quoted = now_.empty() ? "'end of file'" : shown(now_);
    return quoted.substr(1, quoted.size() - 2);
  }

 private:
  const std::string& source_;
  std::string_view text_;
  std::string_view now_;
  std::size_t place_ = 0;
};

Point take_position(Tokens& tokens) {
  const double x = tokens.take_number();
  const double y = tokens.take_number();
  if (!tokens.is_at_end() && parse_number(tokens.now()))
    tokens.fail("a point of more than two coordinates; leave out z and m");
  return {x, y};
}

// "(1 2)", or "((1 2), (3 4))", or "(1 2, 3 4)".
void take_positions(Tokens& tokens, bool are_many, std::vector<Point>& points) {
  tokens.require("(");
  do {
    const bool has_own_brackets = are_many && tokens.take("(");
    points.push_back(take_position(tokens));
    if (has_own_brackets) tokens.require(")");
  } while (are_many && tokens.take(","));
  tokens.require(")");
}

}  // namespace

std::vector<Point> parse_wkt_points(const std::string& source, std::string_view text) {
  Tokens tokens(source, text);
  std::vector<Point> points;
  while (!tokens.is_at_end()) {
    const std::string word = lower_case(tokens.now());
    if (word.starts_with("srid=")) {
      tokens.next();
      tokens.require(";");
      continue;
    }
    if (word != "point" && word != "multipoint")
      tokens.fail("'" + tokens.shown_now() +
                  "' where there should be POINT or MULTIPOINT; other geometries are no points");
    tokens.next();
    if (lower_case(tokens.now()) == "empty") {
      tokens.next();
      continue;
    }
    if (tokens.is_word())
      tokens.fail("'" + tokens.shown_now() + "': points of more than two coordinates; leave out z and m");
    take_positions(tokens, word == "multipoint", points);
    while (tokens.take(",") || tokens.take(";")) {
    }
  }
  if (points.empty()) throw InputError(source + ": no points in it");
  return points;
}

bool looks_like_wkt(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return false;
  constexpr std::size_t kLongestWord = 20;
  const std::string head = lower_case(text.substr(start, kLongestWord));
  for (const char* word : {"srid=", "point", "multipoint", "linestring", "polygon", "multilinestring", "multipolygon",
                           "geometrycollection"}) {
    const std::string_view rest = std::string_view(head).substr(std::min(head.size(), std::string_view(word).size()));
    const std::size_t next = rest.find_first_not_of(" \t");
    const bool goes_on = next != std::string_view::npos &&
                         (rest[next] == '(' || rest[next] == 'z' || rest[next] == 'm' || rest[next] == 'e');
    if (head.starts_with(word) && (goes_on || word == std::string_view("srid="))) return true;
  }
  return false;
}

}  // namespace mwt
