// Point sets of many shapes for tests: generic ones, lattices, ties, near-ties, collinear rows, extreme magnitudes.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "geometry/point.h"

namespace mwt::test {

/// A family of point sets: distinct points, not all collinear, about n of them (some shapes round, grids may repeat
/// less). Deterministic for a state of the engine.
struct ShapeFamily {
  std::string name;
  std::vector<Point> (*make)(std::size_t n, std::mt19937_64& random);
  std::size_t max_n = 1'000'000;  ///< coordinates beyond all filters make every decision take microseconds
};

[[nodiscard]] const std::vector<ShapeFamily>& shapes();

/// At most min(n, shape.max_n) points of the shape, seeded; n >= 3.
[[nodiscard]] std::vector<Point> make_shape(const ShapeFamily& shape, std::size_t n, std::uint64_t seed);

/// One point set with its name, for messages.
struct Shape {
  std::string name;
  std::vector<Point> points;
};

/// One point set of every family, and small or degenerate ones that no family contains. Distinct points, not all
/// collinear, in a pseudo-random order.
[[nodiscard]] std::vector<Shape> all_shapes();

/// In [0, 1); the same on every platform.
[[nodiscard]] double random_unit(std::mt19937_64& random);

[[nodiscard]] std::vector<Point> uniform_points(std::size_t n, std::uint64_t seed);
[[nodiscard]] std::vector<Point> circle_points(std::size_t n);
[[nodiscard]] std::vector<Point> full_lattice(int columns, int rows);
/// Points on parallel lines: the hull has many collinear points on two or all of its sides.
[[nodiscard]] std::vector<Point> parallel_rows(int rows, int per_row);
/// A triangle whose three sides carry collinear points, and one point inside.
[[nodiscard]] std::vector<Point> triangle_with_points_on_sides(int per_side);
[[nodiscard]] std::vector<Point> scaled(std::vector<Point> points, double x_factor, double y_factor);
[[nodiscard]] std::vector<Point> shuffled(std::vector<Point> points, std::uint64_t seed);

}  // namespace mwt::test
