// Distant ears of a face's boundary, cut off in bulk: they enter the mesh only when all are known.
#pragma once

#include <cstddef>

#include "algorithms/greedy/greedy_parts.h"

namespace mwt {

class FaceBoundary;

/// Whether take_pockets() is worth while, from a sample of the boundary. O(1) samples.
[[nodiscard]] bool are_pockets_promising(const GreedyParts& parts, FaceBoundary& boundary);

/// Cuts distant ears (DistantEars) off the boundary, none of whose corners is cut, and fixes them in the mesh. For long
/// boundaries with nothing near them, such as a curve of many points: a look at an ear takes constant time, however
/// long it is, and each pocket comes into the mesh at once. Works stretch by stretch of so many corners: they fit the
/// cache with the longest of their ears. Gives up when it meets too much that is near. Stops at the deadline. Exact;
/// linear time but for the flips.
///
/// Returns how many of the ears were no edges of the mesh before, as far as known.
std::size_t take_pockets(const GreedyParts& parts, FaceBoundary& boundary, std::size_t stretch = 1 << 16);

}  // namespace mwt
