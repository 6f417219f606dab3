// Points uniform in the unit square.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo uniform_entry();

/// n distinct points, independent and uniform in [0, 1) x [0, 1), not all collinear. Precondition: n >= 3. The same on
/// every platform. Expected O(n) time.
[[nodiscard]] std::vector<Point> uniform_points(Index n, std::uint64_t seed);

}  // namespace mwt
