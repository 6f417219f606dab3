// The margins of floating-point comparisons in the mesh and the algorithms on it, each with its reason.
//
// All are relative, and hold in the ranges of geometry/numbers/trusted_range.h. Every margin is several times the
// errors that it covers, so that no proof depends on its last digit.
#pragma once

namespace mwt {

/// Between squared distances by the plain formula (rounded_squared_distance()), each of which errs by less than 4.5e-16
/// of itself.
inline constexpr double kSquareMargin = 1e-14;

/// Between results of a few operations on differences of coordinates, which each err by some 1e-16 of the product of
/// the lengths that enter: scalar and vector products, sums of angles, bounds made of them.
inline constexpr double kProductMargin = 1e-12;

/// Where a squared length is rounded to a float (EdgeRecord::squared_length), which errs by 2^-24 = 6e-8 of itself.
inline constexpr double kFloatMargin = 1e-6;

}  // namespace mwt
