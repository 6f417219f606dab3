// Contour lines of a random landscape, as maps show them.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo contours_entry();

/// Points along the level lines of a landscape over the unit square: a sum of `summits` bumps h / (1 + d^2 / r^2)^2
/// with random centres, heights h from .3 to 1 and widths r from .1 to .3. `levels` heights, evenly spaced; each line
/// is followed from cell to cell of a grid, straight within a cell, and carries points about evenly spaced along all
/// lines. Preconditions: 1 <= levels, 1 <= summits. Distinct points, not all collinear; the same on every platform.
/// Expected O(n + grid) time.
[[nodiscard]] std::vector<Point> contours_points(Index n, std::uint64_t seed, Index levels, Index summits);

}  // namespace mwt
