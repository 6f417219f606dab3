// Uniform points in a ring.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo annulus_entry();

/// n distinct points, uniform by area between the circles of radius `inner` and 1 around the origin.
/// Preconditions: n >= 3, 0 <= inner <= .999999. The same on every platform. Expected O(n).
[[nodiscard]] std::vector<Point> annulus_points(Index n, std::uint64_t seed, double inner);

}  // namespace mwt
