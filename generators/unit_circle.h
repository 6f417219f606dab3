// Points on the unit circle without the mathematics library, whose sin and cos differ between platforms.
#pragma once

#include <cstdint>

#include "geometry/point.h"

namespace mwt {

/// (cos t, sin t) for t = 2 pi numerator / denominator.
///
/// Precondition: numerator < denominator <= 2^53. Postconditions: the same on every platform (only correctly rounded
/// operations); each coordinate errs by less than .500001 units in its last place; the eight symmetries of the octants
/// hold exactly, so that antipodal points are exact opposites and multiples of 90 degrees are exact. O(1), about a
/// microsecond.
[[nodiscard]] Point unit_circle_point(std::uint64_t numerator, std::uint64_t denominator);

}  // namespace mwt
