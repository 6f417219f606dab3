// Points that are collinear but for a hair.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo near_collinear_entry();

/// Point i is ((i + r/2) / n, height * s) with r, s uniform in [0, 1): from left to right, distinct, not all collinear.
/// Preconditions: n >= 3, height > 0. The same on every platform. Expected O(n) time.
[[nodiscard]] std::vector<Point> near_collinear_points(Index n, std::uint64_t seed, double height);

}  // namespace mwt
