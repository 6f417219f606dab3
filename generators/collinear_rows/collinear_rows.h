// A few horizontal rows of equally spaced points.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo collinear_rows_entry();

/// Point i is (i div rows, gap * (i mod rows)): column after column, the last one cut short unless rows divides n. Rows
/// are exactly horizontal. Preconditions: rows >= 2, n > rows, gap > 0. O(n).
/// Known optimum of two rows of k points: 2 (k - 1) + k gap + (k - 1) sqrt(1 + gap^2).
[[nodiscard]] std::vector<Point> collinear_rows(Index n, Index rows, double gap);

}  // namespace mwt
