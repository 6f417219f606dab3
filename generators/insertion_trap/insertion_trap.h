// A tiny circle that is triangulated from far away before any point near it is inserted (F5).
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo insertion_trap_entry();

/// The triangle (0, 2), (-2, -1), (2, -1); then k = n - 6 points of a regular polygon of radius rho = 2^-20 around the
/// origin; then the triangle (0, 4 rho), (-4 rho, -2 rho), (4 rho, -2 rho) around that polygon.
///
/// Why it is bad: all triangles between the circle's points are empty, so every insertion splits a triangle with a far
/// corner and adds an edge of length about 2; the three points that would keep the polygon to itself come last, and in
/// random order they help only what comes after them. The optimum is O(1): alpha of order n.
/// Precondition: 7 <= n <= kMaxInsertionTrap. The same on every platform (scaling by 2^-20 is exact). O(n).
[[nodiscard]] std::vector<Point> insertion_trap_points(Index n);

/// As for the regular polygon (circle.h), with angles of a quarter step.
inline constexpr Index kMaxInsertionTrap = 10'000'000;

}  // namespace mwt
