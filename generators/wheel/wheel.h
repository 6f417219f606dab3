// The wheel: a regular polygon and its centre.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo wheel_entry();

/// The regular (n - 1)-gon on the unit circle, its i-th vertex moved outwards to distance 1 + growth i / (n - 1), then
/// the origin; each moved by a vector uniform in a square of side `jitter` around it; distinct, not all collinear.
/// Preconditions: 4 <= n <= kMaxRegularPolygon, 0 <= jitter <= 1, 0 <= growth <= 1; jitter 0 and growth 0 is the
/// exact wheel, the same for every seed. With increasing spokes and no jitter, greedy meets the spokes one by one
/// around the centre: an algorithm that scans all edges of a vertex for each new one takes quadratic time. The same on
/// every platform. Expected O(n) time.
[[nodiscard]] std::vector<Point> wheel_points(Index n, std::uint64_t seed, double jitter, double growth = 0);

}  // namespace mwt
