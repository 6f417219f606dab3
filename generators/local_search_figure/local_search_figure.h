// The ten points behind the source report's local search figures.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo local_search_figure_entry();

/// A configuration for Figures 7 to 11 of section 5.3.1. The source report prints no coordinates, only the perimeters
/// of the triangles; these points were recovered from them for this project: all 15 listed perimeters agree to the four
/// printed decimals, and the totals round to 11.0751, 10.9347 and 10.7929. Exact to the decimals below, fixed only up
/// to a congruence and to what four decimals leave open.
[[nodiscard]] std::vector<Point> local_search_figure_points();

}  // namespace mwt
