// All empty triangles of a point set.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/deadline.h"
#include "geometry/triangulation.h"

namespace mwt {

/// The triangles that hold no point but their corners, boundary included, each once: counter-clockwise, starting at the
/// smallest index, in lexicographic order. They are the triangles that can occur in a triangulation.
///
/// Precondition: distinct points. Exact. O(n^3) orientation tests and O(n^4 / 64) word operations, n^3 / 8 bytes: meant
/// for a few hundred points, of which uniform ones have about 2 n^2 empty triangles and points in convex position n^3
/// / 6.
[[nodiscard]] std::vector<Triangle> empty_triangles(Points points);

/// The same, unless the deadline passes first or there are more than `most` of them: then nothing.
[[nodiscard]] std::optional<std::vector<Triangle>> empty_triangles(Points points, std::size_t most,
                                                                   const Deadline& deadline);

}  // namespace mwt
