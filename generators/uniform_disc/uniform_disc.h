// Points uniform in the unit disc.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo uniform_disc_entry();

/// n distinct points, independent and uniform in the closed unit disc around the origin, not all collinear.
/// Precondition: n >= 3. By rejection from the square: no trigonometry, so the same on every platform. Expected O(n)
/// time.
[[nodiscard]] std::vector<Point> uniform_disc_points(Index n, std::uint64_t seed);

}  // namespace mwt
