// Outlines of a plate with round holes, as computer-aided design gives them.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo cad_plate_entry();

enum class PlateOutline {
  rectangle,  ///< around the cells of the holes
  circle,     ///< likewise; with one hole, a ring
  star        ///< of 12 tips, likewise
};

/// Points along the outline of a plate and of `holes` circles in it, one in the middle of each cell of a grid of
/// squares of side 2; radii are random between .3 and .8. All outlines are sampled about equally densely: evenly along
/// each circle and each straight side, whose corners are points. Preconditions: n >= 24 + 3 holes for a star, 4 + 3
/// holes otherwise. Distinct points; the same on every platform. O(n).
[[nodiscard]] std::vector<Point> cad_plate_points(Index n, std::uint64_t seed, PlateOutline outline, Index holes);

}  // namespace mwt
