// Uniform points, some of them repeated: the only family that is no set.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo with_duplicates_entry();

/// n points in random order, of which max(3, n - floor(share n)) are distinct, uniform in the unit square and not all
/// collinear; the others are copies of these, chosen at random. Preconditions: n >= 3, 0 <= share < 1. The same on
/// every platform. Expected O(n) time.
[[nodiscard]] std::vector<Point> points_with_duplicates(Index n, std::uint64_t seed, double share);

}  // namespace mwt
