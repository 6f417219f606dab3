// Random points on a circle.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo convex_position_entry();

/// n different vertices of the regular 2^26-gon, all choices equally likely, in random order: points at independent
/// random angles on the unit circle, in strictly convex position for certain (circle.h; a subset of vertices is in
/// strictly convex position as well). Precondition: 3 <= n <= kMaxConvexPosition. The same on every platform.
/// Expected O(n).
[[nodiscard]] std::vector<Point> convex_position_points(Index n, std::uint64_t seed);

/// A seventh of the possible vertices.
inline constexpr Index kMaxConvexPosition = 10'000'000;

}  // namespace mwt
