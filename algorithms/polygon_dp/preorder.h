// The order in which the dynamic programs list a polygon's triangles.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// The triangles of a triangulation of a polygon whose vertices are 0 .. size - 1 in counter-clockwise order: first
/// (0, k, size - 1), then those of the part from 0 to k, then those of the part from k on, each part in the same way.
/// O(size) expected.
[[nodiscard]] std::vector<Triangle> in_preorder(std::vector<Triangle> triangles, std::size_t size);

}  // namespace mwt
