// Points whose distances from the origin spread over many orders of magnitude.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo log_radial_entry();

/// n distinct points in uniform directions; the distance from the origin is uniform within [2^-e, 2^(1-e)), with e
/// uniform among 1 .. octaves: nearly uniform on a logarithmic scale.
/// Preconditions: n >= 3, 1 <= octaves <= 1000. The same on every platform. Expected O(n).
[[nodiscard]] std::vector<Point> log_radial_points(Index n, std::uint64_t seed, Index octaves);

}  // namespace mwt
