// A line of points and one apex: the set with exactly one triangulation.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo fan_entry();

/// (i, 0) for i = 0 .. n - 2, then the apex (floor(n / 2), 1). Exact small integers. Precondition: n >= 3. O(n).
/// Known optimum: the only triangulation, (n - 2) + sum over i of sqrt((i - floor(n / 2))^2 + 1).
[[nodiscard]] std::vector<Point> fan_points(Index n);

}  // namespace mwt
