// The Delaunay triangulation as an algorithm of the registry: the baseline of every comparison.
#pragma once

#include "algorithms/algorithm.h"

namespace mwt {

/// Wraps delaunay_triangulation() of geometry/delaunay.h, where the contract stands. No parameters, no deadline.
[[nodiscard]] AlgorithmInfo delaunay_entry();

}  // namespace mwt
