// Thirteen points whose optimum weighs less than their hull's.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo hull_bound_counterexample_entry();

/// A convex 12-gon, counter-clockwise, and the origin inside it. The lightest diagonals of the 12-gon alone weigh
/// 493.7304, the twelve spokes from the origin 491.7044: with the hull 848.848 against 846.822, so that the optimum of
/// the hull's corners is no lower bound for that of all points. Exact integers. Found for this project.
[[nodiscard]] std::vector<Point> hull_bound_counterexample_points();

}  // namespace mwt
