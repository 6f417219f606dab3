#include "generators/cad_plate/cad_plate.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "generators/arguments.h"
#include "generators/grid/grid.h"
#include "generators/random.h"
#include "generators/unit_circle.h"

namespace mwt {

namespace {

constexpr double kCell = 2;
constexpr Index kTips = 12;
constexpr double kCircumference = 6.283185307179586;  // of the unit circle

// How many of the points an outline of this length gets: its share, but no fewer than `least`, and no more than leaves
// `least` for each of those behind it.
class Shares {
 public:
  Shares(Index points, double length) : points_(points), length_(length) {}

  Index take(double length, Index least, Index min_behind) {
    const auto share = static_cast<Index>(static_cast<double>(points_) * (length / length_));
    const Index taken = std::min(std::max(share, least), points_ - min_behind);
    points_ -= taken;
    length_ -= length;
    return taken;
  }

  [[nodiscard]] Index rest() const { return points_; }

 private:
  Index points_;
  double length_;
};

void append_side(std::vector<Point>& points, const Point& from, const Point& to, Index count) {
  for (Index i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / count;
    points.push_back({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
  }
}

void append_circle(std::vector<Point>& points, const Point& centre, double radius, Index count) {
  for (Index i = 0; i < count; ++i) {
    const Point p = unit_circle_point(i, count);
    points.push_back({centre.x + radius * p.x, centre.y + radius * p.y});
  }
}

double distance(const Point& p, const Point& q) {
  const double x = p.x - q.x, y = p.y - q.y;
  return std::sqrt(x * x + y * y);
}

// The outer border: a polygon, or without corners a circle.
struct Border {
  std::vector<Point> corners;
  Point centre;
  double radius = 0;

  [[nodiscard]] double length() const {
    if (corners.empty()) return kCircumference * radius;
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) sum += distance(corners[i], corners[(i + 1) % corners.size()]);
    return sum;
  }
};

// Around a rectangle from the origin.
Border make_border(PlateOutline outline, double width, double height) {
  Border border;
  border.centre = {width / 2, height / 2};
  border.radius = .55 * distance({0, 0}, {width, height});
  if (outline == PlateOutline::rectangle) border.corners = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  for (Index i = 0; outline == PlateOutline::star && i < 2 * kTips; ++i) {
    const Point direction = unit_circle_point(i, 2 * kTips);
    const double radius = i % 2 == 0 ? 1.6 * border.radius : border.radius;
    border.corners.push_back({border.centre.x + radius * direction.x, border.centre.y + radius * direction.y});
  }
  return border;
}

Index min_n(PlateOutline outline, std::uint64_t holes) {
  return static_cast<Index>((outline == PlateOutline::star ? 2 * kTips : 4) + 3 * holes);
}

PlateOutline outline_named(const std::string& name) {
  return name == "circle" ? PlateOutline::circle : name == "star" ? PlateOutline::star : PlateOutline::rectangle;
}

}  // namespace

GeneratorInfo cad_plate_entry() {
  return {
      .name = "cad_plate",
      .summary = "outlines of a plate with round holes",
      .source = "the look of plates in computer-aided design",
      .stresses = "exact solvers: faces with true holes between curves; greedy and patch along facing curves",
      .law = "none known",
      .min_n = 10,
      .max_n = kMaxPoints,
      .parameters = {{"outline",
                      ParameterType::choice,
                      "rectangle",
                      "of the plate: a rectangle, a circle (with one hole: a ring) or a star",
                      {"rectangle", "circle", "star"}},
                     {"holes", ParameterType::integer, "2", "number of holes; n is at least 4 (star: 24) + 3 holes"}},
      .function = [](Index n, std::uint64_t seed, const Parameters& parameters) {
        const auto holes = static_cast<Index>(integer_within("cad_plate", parameters, "holes", 0, 1'000'000));
        const PlateOutline outline = outline_named(parameters.text("outline"));
        require_size("cad_plate", n, min_n(outline, holes), kMaxPoints);
        return cad_plate_points(n, seed, outline, holes);
      }};
}

std::vector<Point> cad_plate_points(Index n, std::uint64_t seed, PlateOutline outline, Index holes) {
  RandomEngine engine = make_engine("cad_plate", seed);
  const Index columns = ceiling_square_root(std::max(holes, Index{1}));
  const Index rows = (std::max(holes, Index{1}) + columns - 1) / columns;
  const Border border = make_border(outline, kCell * columns, kCell * rows);
  double length = border.length();
  std::vector<double> radii;
  for (Index i = 0; i < holes; ++i) {
    radii.push_back(.3 + .5 * uniform_unit(engine));
    length += kCircumference * radii.back();
  }
  Shares shares(n, length);
  std::vector<Point> points;
  points.reserve(n);
  const auto corners = static_cast<Index>(border.corners.size());
  for (Index i = 0; i < corners; ++i) {
    const Point &from = border.corners[i], &to = border.corners[(i + 1) % corners];
    const bool is_last = holes == 0 && i + 1 == corners;
    append_side(points, from, to,
                is_last ? shares.rest() : shares.take(distance(from, to), 1, (corners - 1 - i) + 3 * holes));
  }
  if (corners == 0) {
    append_circle(points, border.centre, border.radius,
                  holes == 0 ? shares.rest() : shares.take(border.length(), 4, 3 * holes));
  }
  for (Index i = 0; i < holes; ++i) {
    const Point centre{kCell * (i % columns) + kCell / 2, kCell * (i / columns) + kCell / 2};
    const Index behind = holes - 1 - i;
    append_circle(points, centre, radii[i],
                  behind == 0 ? shares.rest() : shares.take(kCircumference * radii[i], 3, 3 * behind));
  }
  return points;
}

}  // namespace mwt
