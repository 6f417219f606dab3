// Points along random polylines, as vertices of a road map lie.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo roads_entry();

/// n distinct points, each at a random place of one of `roads` polylines (all places equally likely). A polyline starts
/// at a random place of the unit square, has 10 legs of length .1, and turns by up to 45 degrees between them. Points
/// of one leg are collinear up to rounding; roads cross. Preconditions: n >= 3, roads >= 1. The same on every platform.
/// Expected O(n + roads).
[[nodiscard]] std::vector<Point> roads_points(Index n, std::uint64_t seed, Index roads);

}  // namespace mwt
