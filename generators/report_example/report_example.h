// The ten points of the source report's worked examples.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo report_example_entry();

/// Points A .. J of sections 5.1.3 and 5.2.3, in that order. Not in general position, although the source report asks
/// for it: (B, H, J), (E, H, I) and (F, G, H) are collinear. Known optimum: 70.9585925243, which is also greedy's
/// weight; 586 triangulations.
[[nodiscard]] std::vector<Point> report_example_points();

}  // namespace mwt
