// Random changes of small point sets, for hill climbing on coordinates.
#pragma once

#include <vector>

#include "generators/random.h"
#include "geometry/point.h"

namespace mwt {

/// n points uniform in the unit square.
[[nodiscard]] std::vector<Point> random_start(Index n, RandomEngine& engine);

/// A changed copy: one to a few moves, each one of
///   - a point shifted by a normal vector, or all points;
///   - a point put anywhere in the bounding box, beside another point, or beside a line through two others;
///   - the set squeezed or stretched along an axis.
/// How far points are shifted is uniform on a logarithmic scale from 10^-4 of the set's extent up to it. A set that
/// has become 4 times as large or small as the unit square is brought back to it. The result may
/// be no instance (duplicates, all collinear). Precondition: at least 3 points.
[[nodiscard]] std::vector<Point> mutated(std::vector<Point> points, RandomEngine& engine);

}  // namespace mwt
