// The source report's Boolean model (section 3): one variable per possible edge, no two edges that cross.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// The triangulations are the sets of `size` edges no two of which cross: exactly the largest such sets.
struct CrossingModel {
  /// Preconditions: distinct points, not all collinear. O(n^4).
  explicit CrossingModel(Points points);

  std::vector<Edge> edges;                           ///< the segments with no point in their interior
  std::vector<std::vector<std::uint32_t>> crossing;  ///< for each edge those that cross it, ascending
  std::size_t size = 0;                              ///< 3 n - 3 - h

  [[nodiscard]] bool cross(std::uint32_t e, std::uint32_t f) const;
};

}  // namespace mwt
