// The integer grid, every point moved a little at random.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo jittered_grid_entry();

/// The points of grid_points(n), each moved by a vector uniform in [-jitter/2, jitter/2) x [-jitter/2, jitter/2);
/// distinct, not all collinear. Preconditions: n >= 3, 0 <= jitter <= 1000. Up to jitter 1 points stay in their cells.
/// The same on every platform. Expected O(n) time.
[[nodiscard]] std::vector<Point> jittered_grid_points(Index n, std::uint64_t seed, double jitter);

}  // namespace mwt
