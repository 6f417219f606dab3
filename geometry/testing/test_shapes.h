// Small point sets for the tests of this layer: general position, lattices, collinear boundaries, extreme ranges.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "geometry/convex_hull.h"
#include "geometry/point.h"

namespace mwt::test {

struct Shape {
  std::string name;
  std::vector<Point> points;
};

/// In [0, 1); the same on every platform.
inline double random_unit(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

inline std::vector<Point> uniform_points(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point> points(n);
  for (Point& p : points) p = {random_unit(random), random_unit(random)};
  return points;
}

inline std::vector<Point> lattice_points(int columns, int rows) {
  std::vector<Point> points;
  for (int x = 0; x < columns; ++x) {
    for (int y = 0; y < rows; ++y) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  return points;
}

/// All 12 lattice points at distance 5 from the origin and, on the same circle scaled, 12 at distance 10.
inline std::vector<Point> cocircular_lattice_points() {
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

/// Rows of points on parallel lines: the hull has many collinear points on two or all of its sides.
inline std::vector<Point> row_points(int rows, int per_row) {
  std::vector<Point> points;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < per_row; ++i) points.push_back({static_cast<double>(i), 7.0 * row});
  }
  return points;
}

/// A triangle whose three sides carry collinear points, and one point inside.
inline std::vector<Point> triangle_with_points_on_sides(int per_side) {
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

inline std::vector<Point> circle_points(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

/// On a line with irrational-looking slope, each point off it by rounding only.
inline std::vector<Point> near_collinear_points(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) points.push_back({0.1 * i, 0.1 * i * 0.7 + 0.3});
  return points;
}

inline std::vector<Point> scaled(std::vector<Point> points, double factor) {
  for (Point& p : points) p = {p.x * factor, p.y * factor};
  return points;
}

inline std::vector<Point> moved(std::vector<Point> points, double dx, double dy) {
  for (Point& p : points) p = {p.x + dx, p.y + dy};
  return points;
}

inline std::vector<Point> shuffled(std::vector<Point> points, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random() % i]);
  return points;
}

/// The first of equal points only (moving and scaling may make points coincide).
inline std::vector<Point> distinct(const std::vector<Point>& points) {
  std::vector<Index> order = lexicographic_order(points);
  order.erase(std::unique(order.begin(), order.end(), [&](Index a, Index b) { return points[a] == points[b]; }),
              order.end());
  std::sort(order.begin(), order.end());
  std::vector<Point> result;
  for (const Index i : order) result.push_back(points[i]);
  return result;
}

/// Distinct points, not all collinear, in a pseudo-random order.
inline std::vector<Shape> all_shapes() {
  std::vector<Shape> shapes{
      {"one triangle", {{0, 0}, {1, 0}, {0, 1}}},
      {"triangle with a point on a side", {{0, 0}, {2, 0}, {0, 2}, {1, 1}}},
      {"triangle with its centre", {{0, 0}, {3, 0}, {0, 3}, {1, 1}}},
      {"square", lattice_points(2, 2)},
      {"uniform 10", uniform_points(10, 1)},
      {"uniform 300", uniform_points(300, 2)},
      {"lattice 5 x 5", lattice_points(5, 5)},
      {"lattice 30 x 7", lattice_points(30, 7)},
      {"cocircular", cocircular_lattice_points()},
      {"two rows", row_points(2, 20)},
      {"five rows", row_points(5, 12)},
      {"triangle with points on its sides", triangle_with_points_on_sides(9)},
      {"circle", circle_points(64)},
      {"near-collinear", near_collinear_points(100)},
      {"line and one point off it", {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {1, 4}}},
      {"uniform far from the origin", moved(uniform_points(200, 3), 1e9, -1e9)},
      {"uniform so far that few doubles are left", moved(uniform_points(200, 4), 0x1p50, 0)},
      {"huge", scaled(uniform_points(100, 5), 1e300)},
      {"huge lattice", scaled(lattice_points(6, 6), 1e299)},
      {"tiny", scaled(uniform_points(100, 6), 1e-300)},
      {"denormal lattice", scaled(lattice_points(6, 6), 5e-324)},
  };
  std::vector<Point> mixed = uniform_points(20, 7);
  for (const double size : {1e-300, 1e-100, 1e100, 1e300}) {
    for (const Point& p : scaled(uniform_points(20, 8), size)) mixed.push_back(p);
  }
  shapes.push_back({"all magnitudes", mixed});
  std::uint64_t seed = 100;
  for (Shape& shape : shapes) shape.points = shuffled(distinct(shape.points), seed++);
  return shapes;
}

}  // namespace mwt::test
