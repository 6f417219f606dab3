// Solves point sets of extreme size in a range where lengths keep their digits.
#pragma once

#include "algorithms/algorithm.h"

namespace mwt {

/// solve(points, context), on the points divided by 2^exact_scale(points) (geometry/numbers/scaling.h) where that is
/// not 1. The solution is in the caller's unit: its bounds on the optimum are scaled back, the upper one being the
/// weight of the triangulation, and so is the context's proof. Counters are as `solve` leaves them.
///
/// An exact solver that adds up lengths must be called this way: among denormals, where a length is a small multiple
/// of 2^-1074, its best sum may belong to a triangulation that is a few percent too heavy.
[[nodiscard]] Solution solve_scaled(Points points, Context& context, const AlgorithmFunction& solve);

}  // namespace mwt
