// Points with small random integer coordinates.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo integer_uniform_entry();

/// n distinct points, uniform among those with integer coordinates 0 .. range - 1, not all collinear. Preconditions:
/// n >= 3, range >= 2, n <= range^2. The same on every platform. Expected O(n) time, O(n log n) if n is near range^2.
[[nodiscard]] std::vector<Point> integer_uniform_points(Index n, std::uint64_t seed, std::uint64_t range);

}  // namespace mwt
