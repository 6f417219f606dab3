// The lattice of equilateral triangles.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo hexagonal_lattice_entry();

/// The first n points of the rows of a lattice with ceil(sqrt n) columns: row r lies at height r sqrt(3) / 2 and every
/// other row is shifted by half a unit, so that neighbours are at distance 1 up to rounding. Rows are exactly
/// collinear; the lengths of horizontal and slanted edges differ in their last bits. Precondition: n >= 3. O(n).
[[nodiscard]] std::vector<Point> hexagonal_lattice_points(Index n);

}  // namespace mwt
