// Points from the standard normal distribution of the plane.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo normal_entry();

/// n distinct points whose coordinates are independent standard normals, not all collinear. Precondition: n >= 3.
/// Platforms: see standard_normal() in generators/random.h for the one comparison with std::exp(). Expected O(n) time.
[[nodiscard]] std::vector<Point> normal_points(Index n, std::uint64_t seed);

}  // namespace mwt
