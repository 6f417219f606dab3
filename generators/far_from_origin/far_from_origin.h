// Uniform points far from the origin, where doubles are sparse.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo far_from_origin_entry();

/// n distinct points (offset + r, offset + s), rounded to doubles, with r, s uniform in [0, 1); not all collinear. What
/// rounding merges is drawn again. Preconditions: 3 <= n <= max_far_from_origin(offset). The same on every
/// platform. Expected O(n) time, O(n log n) near the largest n.
[[nodiscard]] std::vector<Point> far_from_origin_points(Index n, std::uint64_t seed, double offset);

/// How many points the unit square at `offset` surely holds: the square of the number of doubles in a side.
[[nodiscard]] std::uint64_t max_far_from_origin(double offset);

}  // namespace mwt
