// Point sets of many shapes for the tests of this layer: generic ones, ties, near-ties, collinear rows, extremes.
#pragma once

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

}  // namespace mwt::test
