// Integer points on one circle: exact ties in convex position.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo integer_circle_entry();

/// n random points, in random order, of the integer points on the smallest of a few circles x^2 + y^2 = R that holds n.
/// R is a product of primes 1 mod 4, which makes the points many (Jacobi: 4 times the number of R's divisors).
/// Precondition: 3 <= n <= kMaxIntegerCircle. Postcondition: exactly cocircular, so in strictly convex position.
/// The same on every platform. O(sqrt R) time, at most 0.02 seconds.
[[nodiscard]] std::vector<Point> integer_circle_points(Index n, std::uint64_t seed);

inline constexpr Index kMaxIntegerCircle = 3072;

}  // namespace mwt
