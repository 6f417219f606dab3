// Uniform points in a tiny square inside a big triangle.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo cluster_in_triangle_entry();

/// The triangle (0, 2), (-2, -1), (2, -1), then n - 3 distinct points uniform in the square of side `side` around the
/// origin.
///
/// Why it is bad for insertion: a point is inserted by joining it to the corners of the triangle that holds it, and
/// near the cluster's rim these triangles have far corners for long; every such edge costs about 2, and about sqrt n of
/// them are made, while the optimum weighs O(1). Preconditions: n >= 4, 1e-12 <= side <= 1. The same on every platform.
/// Expected O(n).
[[nodiscard]] std::vector<Point> cluster_in_triangle_points(Index n, std::uint64_t seed, double side);

}  // namespace mwt
