// Points on a spiral.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo spiral_entry();

/// n points on the Archimedean spiral of `turns` turns, from near the origin outwards: the i-th, i = 1 .. n, at
/// distance i / n and angle 2 pi turns (i - 1) / n. Preconditions: turns >= 1, n >= 2 turns + 1. The same on every
/// platform. O(n).
[[nodiscard]] std::vector<Point> spiral_points(Index n, Index turns);

}  // namespace mwt
