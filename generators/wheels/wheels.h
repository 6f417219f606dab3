// Several jittered wheels side by side (F7).
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo wheels_entry();

/// Wheels of `size` points (a regular polygon of radius 1 and its centre; the last wheel takes what is left of n and
/// may be smaller or larger), their centres on a square grid of spacing 3, every point moved by a vector uniform in a
/// square of side `jitter`. Each wheel is a face with an isolated inner vertex for the LMT-skeleton. Preconditions: n
/// >= 4, size >= 4, 0 <= jitter <= 1. The same on every platform. Expected O(n) time.
[[nodiscard]] std::vector<Point> wheels_points(Index n, std::uint64_t seed, Index size, double jitter);

}  // namespace mwt
