#include "generators/contours/contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

namespace {

constexpr Index kCells = 192;  // along each side of the unit square

struct Bump {
  Point centre;
  double height;
  double width;
};

// Heights at the corners of a square grid.
class Landscape {
 public:
  Landscape(RandomEngine& engine, Index summits) {
    std::vector<Bump> bumps;
    for (Index i = 0; i < summits; ++i) {
      const Point centre = uniform_in_square(engine);
      const double height = .3 + .7 * uniform_unit(engine), width = .1 + .2 * uniform_unit(engine);
      bumps.push_back({centre, height, width});
    }
    for (Index row = 0; row <= kCells; ++row) {
      for (Index column = 0; column <= kCells; ++column) heights_.push_back(height_of(bumps, place(column, row)));
    }
  }

  [[nodiscard]] static Point place(Index column, Index row) {
    return {static_cast<double>(column) / kCells, static_cast<double>(row) / kCells};
  }
  [[nodiscard]] double height(Index column, Index row) const { return heights_[row * (kCells + 1) + column]; }
  [[nodiscard]] double lowest() const { return *std::min_element(heights_.begin(), heights_.end()); }
  [[nodiscard]] double highest() const { return *std::max_element(heights_.begin(), heights_.end()); }

 private:
  static double height_of(const std::vector<Bump>& bumps, const Point& p) {
    double height = 0;
    for (const Bump& bump : bumps) {
      const double x = p.x - bump.centre.x, y = p.y - bump.centre.y;
      const double fall = 1 + (x * x + y * y) / (bump.width * bump.width);
      height += bump.height / (fall * fall);
    }
    return height;
  }

  std::vector<double> heights_;
};

// The lines at one height. They enter and leave cells through the grid's edges; each such edge has at most one place at
// this height, and at most two cells.
class LevelLines {
 public:
  LevelLines(const Landscape& landscape, double level) : landscape_(landscape), level_(level) {
    neighbours_.assign(2 * std::size_t{kCells + 1} * (kCells + 1), {kNoIndex, kNoIndex});
    for (Index row = 0; row < kCells; ++row) {
      for (Index column = 0; column < kCells; ++column) cross_cell(column, row);
    }
  }

  // Open lines first, then closed ones, whose first point is repeated at their end.
  std::vector<std::vector<Point>> take() {
    std::vector<std::vector<Point>> lines;
    for (const bool closed : {false, true}) {
      for (Index edge = 0; edge < neighbours_.size(); ++edge) {
        const bool is_start = neighbours_[edge][0] != kNoIndex && (closed || neighbours_[edge][1] == kNoIndex);
        if (is_start) lines.push_back(follow(edge));
      }
    }
    return lines;
  }

 private:
  // Grid edges: from a corner to the right and upwards.
  static Index right_of(Index column, Index row) { return 2 * (row * (kCells + 1) + column); }
  static Index above(Index column, Index row) { return right_of(column, row) + 1; }

  [[nodiscard]] bool is_high(Index column, Index row) const { return landscape_.height(column, row) > level_; }

  void join(Index edge, Index other) {
    for (const auto& [one, two] : {std::pair(edge, other), std::pair(other, edge)}) {
      auto& known = neighbours_[one];
      (known[0] == kNoIndex ? known[0] : known[1]) = two;
    }
  }

  void cross_cell(Index column, Index row) {
    std::array<Index, 4> crossed{};
    std::size_t count = 0;
    const bool a = is_high(column, row), b = is_high(column + 1, row);
    const bool c = is_high(column + 1, row + 1), d = is_high(column, row + 1);
    if (a != b) crossed[count++] = right_of(column, row);
    if (b != c) crossed[count++] = above(column + 1, row);
    if (c != d) crossed[count++] = right_of(column, row + 1);
    if (d != a) crossed[count++] = above(column, row);
    if (count >= 2) join(crossed[0], crossed[1]);
    if (count == 4) join(crossed[2], crossed[3]);  // at a saddle
  }

  [[nodiscard]] Point place_on(Index edge) const {
    const Index corner = edge / 2, column = corner % (kCells + 1), row = corner / (kCells + 1);
    const Index next_column = column + (edge % 2 == 0 ? 1 : 0), next_row = row + (edge % 2 == 0 ? 0 : 1);
    const double here = landscape_.height(column, row), there = landscape_.height(next_column, next_row);
    const double part = (level_ - here) / (there - here);
    const Point p = Landscape::place(column, row), q = Landscape::place(next_column, next_row);
    return {p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)};
  }

  // Takes the line out.
  std::vector<Point> follow(Index start) {
    std::vector<Point> line{place_on(start)};
    for (Index at = start;;) {
      auto& known = neighbours_[at];
      const Index next = known[0];
      if (next == kNoIndex) return line;
      known[0] = known[1];
      known[1] = kNoIndex;
      auto& back = neighbours_[next];
      if (back[0] == at) back[0] = back[1];
      back[1] = kNoIndex;
      line.push_back(place_on(next));
      at = next;
    }
  }

  const Landscape& landscape_;
  double level_;
  std::vector<std::array<Index, 2>> neighbours_;  // by grid edge: the next ones on its line
};

// All lines one after the other, by the distance from the beginning of the first.
class Course {
 public:
  void add(const std::vector<Point>& line) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double x = line[i].x - line[i - 1].x, y = line[i].y - line[i - 1].y;
      length_ += std::sqrt(x * x + y * y);
      pieces_.push_back({line[i - 1], line[i]});
      ends_.push_back(length_);
    }
  }

  [[nodiscard]] double length() const { return length_; }

  [[nodiscard]] Point at(double distance) const {
    const auto end = std::lower_bound(ends_.begin(), ends_.end(), distance);
    const auto i = std::min(static_cast<std::size_t>(end - ends_.begin()), ends_.size() - 1);
    const double begin = i == 0 ? 0 : ends_[i - 1];
    const double part = ends_[i] > begin ? (distance - begin) / (ends_[i] - begin) : 0;
    const auto& [p, q] = pieces_[i];
    return {p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)};
  }

 private:
  std::vector<std::pair<Point, Point>> pieces_;
  std::vector<double> ends_;
  double length_ = 0;
};

}  // namespace

GeneratorInfo contours_entry() {
  return {.name = "contours",
          .summary = "points along the contour lines of a random landscape",
          .source = "the look of digitised contour maps, a common input of terrain models",
          .stresses = "exact solvers: nested curves with wide gaps; islands; greedy and patch along facing curves",
          .law = "none known",
          .max_n = kMaxPoints,
          .parameters = {{"levels", ParameterType::integer, "10", "number of heights, 1 to 1000"},
                         {"summits", ParameterType::integer, "8", "number of bumps, 1 to 1000"}},
          .function = [](Index n, std::uint64_t seed, const Parameters& parameters) {
            const auto levels = integer_within("contours", parameters, "levels", 1, 1000);
            const auto summits = integer_within("contours", parameters, "summits", 1, 1000);
            return contours_points(n, seed, static_cast<Index>(levels), static_cast<Index>(summits));
          }};
}

std::vector<Point> contours_points(Index n, std::uint64_t seed, Index levels, Index summits) {
  RandomEngine engine = make_engine("contours", seed);
  const Landscape landscape(engine, summits);
  Course course;
  const double lowest = landscape.lowest(), highest = landscape.highest();
  for (Index level = 0; level < levels; ++level) {
    const double height = lowest + (highest - lowest) * ((level + .5) / levels);
    for (const std::vector<Point>& line : LevelLines(landscape, height).take()) course.add(line);
  }
  const double step = course.length() / n;
  return draw_distinct_points("contours", n, [&](Index i) { return course.at(step * (i + uniform_unit(engine))); });
}

}  // namespace mwt
