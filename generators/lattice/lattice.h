// An integer lattice with holes.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo lattice_entry();

/// n points of the smallest square lattice g x g that leaves a share of at least `holes` of its points out, chosen at
/// random (all choices are equally likely), row by row, not all collinear. Exact small integers. Preconditions: n >= 3,
/// 0 <= holes <= .99. The same on every platform. O(n / (1 - holes)) time.
[[nodiscard]] std::vector<Point> lattice_points(Index n, std::uint64_t seed, double holes);

}  // namespace mwt
