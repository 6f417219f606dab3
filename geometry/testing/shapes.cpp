#include "geometry/testing/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "geometry/convex_hull.h"

namespace mwt::test {

namespace {

using Random = std::mt19937_64;

double integer(Random& random, std::uint64_t limit) { return static_cast<double>(random() % limit); }

Point polar(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }
double full_turn(Random& random) { return 2 * std::numbers::pi * random_unit(random); }

std::vector<Point> times(std::size_t n, Random& random, Point (*make)(Random&)) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(make(random));
  return points;
}

std::vector<Point> uniform(std::size_t n, Random& random) {
  return times(n, random, [](Random& r) { return Point{random_unit(r), random_unit(r)}; });
}

std::vector<Point> small_grid(std::size_t n, Random& random) {
  const auto side = static_cast<std::uint64_t>(std::sqrt(2.0 * static_cast<double>(n))) + 2;
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = integer(random, side);
    points.push_back({x, integer(random, side)});
  }
  return points;
}

std::vector<Point> square_lattice(std::size_t n, Random& random) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n))) + 1;
  std::vector<Point> points;
  for (std::size_t i = 0; i < side * side; ++i) {
    points.push_back({static_cast<double>(i % side), static_cast<double>(i / side)});
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

std::vector<Point> lattice_of_thirds(std::size_t n, Random& random) {
  std::vector<Point> points = square_lattice(n, random);
  for (Point& p : points) p = {p.x / 3, p.y / 7};
  return points;
}

std::vector<Point> hexagonal_lattice(std::size_t n, Random& random) {
  std::vector<Point> points = square_lattice(n, random);
  for (Point& p : points) p = {p.x + std::fmod(p.y, 2) / 2, p.y * std::sqrt(0.75)};
  return points;
}

// Integer points on x^2 + y^2 = (5 * 13 * 17)^2, and some inside.
std::vector<Point> integer_circle(std::size_t n, Random& random) {
  constexpr int kRadius = 5 * 13 * 17;
  std::vector<Point> circle;
  for (int x = -kRadius; x <= kRadius; ++x) {
    const auto y = static_cast<int>(std::lround(std::sqrt(kRadius * kRadius - x * x)));
    if (x * x + y * y != kRadius * kRadius) continue;
    circle.push_back({static_cast<double>(x), static_cast<double>(y)});
    circle.push_back({static_cast<double>(x), static_cast<double>(-y)});
  }
  std::shuffle(circle.begin(), circle.end(), random);
  circle.resize(std::min(circle.size(), n));
  while (circle.size() < n) circle.push_back({integer(random, 3) - 1, integer(random, 2 * kRadius) - kRadius});
  return circle;
}

std::vector<Point> regular_polygon(std::size_t n, Random& random) {
  std::vector<Point> points;
  const double start = full_turn(random);
  for (std::size_t i = 0; i < n; ++i) {
    points.push_back(polar(1, start + 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n)));
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

std::vector<Point> random_on_circle(std::size_t n, Random& random) {
  return times(n, random, [](Random& r) { return polar(1, full_turn(r)); });
}

std::vector<Point> collinear_rows(std::size_t n, Random& random) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({integer(random, 4 * n), integer(random, 3)});
  return points;
}

std::vector<Point> one_off_a_line(std::size_t n, Random& random) {
  std::vector<Point> points{{integer(random, n), 1 + integer(random, n)}};
  for (std::size_t i = 1; i < n; ++i) points.push_back({static_cast<double>(i), 0});
  return points;
}

std::vector<Point> nearly_collinear(std::size_t n, Random& random) {
  return times(n, random, [](Random& r) {
    const double x = random_unit(r);
    return Point{x, x / 3 + 1e-15 * random_unit(r)};
  });
}

std::vector<Point> clustered(std::size_t n, Random& random) {
  std::vector<Point> points;
  const std::vector<Point> centres = uniform(1 + n / 10, random);
  for (std::size_t i = 0; i < n; ++i) {
    const Point centre = centres[random() % centres.size()],
                offset = polar(0.01 * random_unit(random), full_turn(random));
    points.push_back({centre.x + offset.x, centre.y + offset.y});
  }
  return points;
}

std::vector<Point> wheel(std::size_t n, Random& random) {
  std::vector<Point> points = regular_polygon(n - 1, random);
  points.push_back({0, 0});
  return points;
}

std::vector<Point> wheel_with_growing_spokes(std::size_t n, Random&) {
  std::vector<Point> points{{0, 0}};
  for (std::size_t i = 1; i < n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n);
    points.push_back(polar(1 + share / 2, 2 * std::numbers::pi * share));
  }
  return points;
}

std::vector<Point> far_from_origin(std::size_t n, Random& random) {
  return times(n, random, [](Random& r) { return Point{1e9 + random_unit(r), -3e8 + random_unit(r)}; });
}

std::vector<Point> spiral(std::size_t n, Random& random) {
  return times(n, random, [](Random& r) {
    const double angle = 20 * random_unit(r);
    return polar(angle + 0.01 * random_unit(r), angle);
  });
}

std::vector<Point> log_radial(std::size_t n, Random& random) {
  return times(n, random, [](Random& r) { return polar(std::pow(10, -12 * random_unit(r)), full_turn(r)); });
}

std::vector<Point> huge_coordinates(std::size_t n, Random& random) {
  return times(n, random, [](Random& r) {
    return Point{1e300 * (random_unit(r) - 0.5), 1e300 * (random_unit(r) - 0.5)};
  });
}

std::vector<Point> tiny_coordinates(std::size_t n, Random& random) {
  return times(n, random, [](Random& r) { return Point{1e-300 * random_unit(r), 1e-300 * integer(r, 5)}; });
}

std::vector<Point> every_magnitude(std::size_t n, Random& random) {
  return times(n, random, [](Random& r) { return polar(std::pow(10, 500 * random_unit(r) - 250), full_turn(r)); });
}

std::vector<Point> two_arcs(std::size_t n, Random& random) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double y = random_unit(random) - 0.5;
    points.push_back({i % 2 == 0 ? y * y : 0.6 - y * y, y});
  }
  return points;
}

std::vector<Point> distinct(const std::vector<Point>& points) {
  std::set<std::pair<double, double>> seen;
  std::vector<Point> result;
  for (const Point& p : points) {
    if (seen.insert({p.x, p.y}).second) result.push_back(p);
  }
  return result;
}

// All 12 lattice points at distance 5 from the origin and, on the same circle scaled, 12 at distance 10.
std::vector<Point> cocircular_lattice_points() {
  std::vector<Point> points;
  for (const double scale : {1.0, 2.0}) {
    for (const auto& [x, y] : {std::pair{5., 0.}, {4., 3.}, {3., 4.}}) {
      for (int turn = 0; turn < 4; ++turn) {
        const Point p{scale * x, scale * y};
        const Point turned[] = {p, {-p.y, p.x}, {-p.x, -p.y}, {p.y, -p.x}};
        points.push_back(turned[turn]);
      }
    }
  }
  return points;
}

// On a line with irrational-looking slope, each point off it by rounding only.
std::vector<Point> points_off_a_line_by_rounding(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) points.push_back({0.1 * i, 0.1 * i * 0.7 + 0.3});
  return points;
}

std::vector<Point> moved(std::vector<Point> points, double dx, double dy) {
  for (Point& p : points) p = {p.x + dx, p.y + dy};
  return points;
}

// Small, degenerate and extreme point sets; moving and scaling may make points coincide.
std::vector<Shape> special_shapes() {
  return {
      {"one triangle", {{0, 0}, {1, 0}, {0, 1}}},
      {"triangle with a point on a side", {{0, 0}, {2, 0}, {0, 2}, {1, 1}}},
      {"triangle with its centre", {{0, 0}, {3, 0}, {0, 3}, {1, 1}}},
      {"square", full_lattice(2, 2)},
      {"line and one point off it", {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {1, 4}}},
      {"uniform 300", uniform_points(300, 2)},
      {"lattice 30 x 7", full_lattice(30, 7)},
      {"two lattice circles", cocircular_lattice_points()},
      {"two rows", parallel_rows(2, 20)},
      {"five rows", parallel_rows(5, 12)},
      {"triangle with points on its sides", triangle_with_points_on_sides(9)},
      {"off a line by rounding only", points_off_a_line_by_rounding(100)},
      {"uniform so far that few doubles are left", moved(uniform_points(200, 4), 0x1p50, 0)},
      {"huge lattice", scaled(full_lattice(6, 6), 1e299, 1e299)},
      {"denormal lattice", scaled(full_lattice(6, 6), 5e-324, 5e-324)},
  };
}

}  // namespace

double random_unit(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

std::vector<Point> uniform_points(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points(n);
  for (Point& p : points) p = {random_unit(random), random_unit(random)};
  return points;
}

std::vector<Point> circle_points(std::size_t n) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    points.push_back(polar(1, 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n)));
  }
  return points;
}

std::vector<Point> full_lattice(int columns, int rows) {
  std::vector<Point> points;
  for (int x = 0; x < columns; ++x) {
    for (int y = 0; y < rows; ++y) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  return points;
}

std::vector<Point> parallel_rows(int rows, int per_row) {
  std::vector<Point> points;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < per_row; ++i) points.push_back({static_cast<double>(i), 7.0 * row});
  }
  return points;
}

std::vector<Point> triangle_with_points_on_sides(int per_side) {
  std::vector<Point> points;
  const double side = per_side + 1;
  for (int i = 0; i <= per_side; ++i) {
    points.push_back({static_cast<double>(i), 0});
    points.push_back({side - i, static_cast<double>(i)});
    points.push_back({0, side - i});
  }
  points.push_back({side / 4, side / 4});
  return points;
}

std::vector<Point> scaled(std::vector<Point> points, double x_factor, double y_factor) {
  for (Point& p : points) p = {x_factor * p.x, y_factor * p.y};
  return points;
}

std::vector<Point> shuffled(std::vector<Point> points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random() % i]);
  return points;
}

std::vector<Shape> all_shapes() {
  constexpr std::size_t kPoints = 100;
  std::vector<Shape> all = special_shapes();
  for (Shape& shape : all) shape.points = distinct(shape.points);
  for (const ShapeFamily& family : shapes()) all.push_back({family.name, make_shape(family, kPoints, 1)});
  std::uint64_t seed = 100;
  for (Shape& shape : all) shape.points = shuffled(shape.points, seed++);
  return all;
}

const std::vector<ShapeFamily>& shapes() {
  constexpr std::size_t kFewPoints = 60;
  static const std::vector<ShapeFamily> all = {
      {"uniform", uniform},
      {"small_grid", small_grid},
      {"full_lattice", square_lattice},
      {"lattice_of_thirds", lattice_of_thirds},
      {"hexagonal_lattice", hexagonal_lattice},
      {"integer_circle", integer_circle},
      {"regular_polygon", regular_polygon},
      {"random_on_circle", random_on_circle},
      {"collinear_rows", collinear_rows},
      {"one_off_a_line", one_off_a_line},
      {"nearly_collinear", nearly_collinear},
      {"clustered", clustered},
      {"wheel", wheel},
      {"wheel_with_growing_spokes", wheel_with_growing_spokes},
      {"far_from_origin", far_from_origin},
      {"spiral", spiral},
      {"log_radial", log_radial},
      {"huge_coordinates", huge_coordinates, kFewPoints},
      {"tiny_coordinates", tiny_coordinates, kFewPoints},
      {"every_magnitude", every_magnitude, kFewPoints},
      {"two_arcs", two_arcs},
  };
  return all;
}

std::vector<Point> make_shape(const ShapeFamily& shape, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  n = std::min(n, shape.max_n);
  while (true) {
    std::vector<Point> points = distinct(shape.make(std::max<std::size_t>(n, 4), random));
    while (points.size() > n) points.pop_back();
    if (points.size() >= 3 && !all_collinear(points)) return points;
  }
}

}  // namespace mwt::test
