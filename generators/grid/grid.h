// The integer grid.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo grid_entry();

/// The first n points of the rows of a grid with ceil(sqrt n) columns: point i is (i mod columns, i div columns), so n
/// = g * g gives the full g x g grid and other n a last row that is cut short. Exact small integers. Precondition: n
/// >= 3. Known optimum of the full grid: 2 g (g - 1) + sqrt(2) (g - 1)^2, all unit edges and one diagonal per cell.
/// O(n).
[[nodiscard]] std::vector<Point> grid_points(Index n);

/// Every point multiplied by `direction`, both as complex numbers: turned by its angle, scaled by its length. Exact for
/// small integers; otherwise rounded, so that rows are collinear and cells square only nearly.
[[nodiscard]] std::vector<Point> tilted(std::vector<Point> points, const Point& direction);

/// ceil(sqrt n), exactly.
[[nodiscard]] Index ceiling_square_root(Index n);

}  // namespace mwt
